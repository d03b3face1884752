// The slot of the keyboard: which keys are held, and how often each was pressed.
#pragma once

#include <optional>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/carried_switches.h"
#include "appliance/programs/input/device_slot.h"
#include "drivers/decode/keyboard.h"

namespace kaori::input {

// One keyboard at a time; keys are physical positions (HID page 7), so that the language of the keyboard does
// not matter. Held keys do not repeat: only the moment at which a key goes down is a press.
class KeyboardSlot final : public DeviceSlot {
 public:
  // Reads the section once; the board is not kept.
  KeyboardSlot(const board::Board& board, board::Writer<board::Keys> writer);

  std::string_view name() const override { return "keyboard"; }
  Result<void> Plug(const ports::HidIdentity& identity, Time now) override;
  Result<void> Accept(std::span<const std::uint8_t> report, Time at) override;
  void Publish() override;
  void Unplug(Time now) override;
  void Tick(Time now, ports::HidChannel* device) override;

 private:
  // Publishes the section with this stamp.
  void Write(Time at);

  board::Writer<board::Keys> writer_;
  CarriedSwitches<8> keys_;
  // Goes on from the board, as the counts in keys_ do.
  board::PressLog log_;
  std::optional<decode::KeyboardDecoder> decoder_;
  board::SourceState source_;
  // When the newest report arrived, and when the keyboard was plugged in.
  Time at_{};
  Time plugged_{};
  bool held_confirmed_ = true;  // As in DialSlot.
  bool changed_ = false;
};

}  // namespace kaori::input
