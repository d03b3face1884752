// The slot of the mouse or tablet: position on the picture, buttons and wheel go to the board.
#pragma once

#include <optional>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/carried_switches.h"
#include "appliance/programs/input/device_slot.h"
#include "drivers/decode/pointer.h"

namespace kaori::input {

// The position stays while nothing is plugged in, and over restarts of the program. It is of the picture,
// 0..1 from the left top, and stops at its edges; the wheel counts notches, away from the operator positive.
class PointerSlot final : public DeviceSlot {
 public:
  // Reads the section once; the board is not kept.
  PointerSlot(const board::Board& board, board::Writer<board::Pointer> writer,
              const decode::PointerSettings& settings);

  std::string_view name() const override { return "pointer"; }
  Result<void> Plug(const ports::HidIdentity& identity, Time now) override;
  Result<void> Accept(std::span<const std::uint8_t> report, Time at) override;
  void Publish() override;
  void Unplug(Time now) override;
  void Tick(Time now, ports::HidChannel* device) override;

 private:
  // Publishes the section as it is, with the carried buttons.
  void Write();

  board::Writer<board::Pointer> writer_;
  // For the decoder of the next device; how many counts of a mouse are the picture's width and height.
  decode::PointerSettings settings_;
  board::Stamped<board::Pointer> pointer_;
  CarriedSwitches<1> buttons_;
  std::optional<decode::PointerDecoder> decoder_;
  Time plugged_{};
  bool held_confirmed_ = true;  // As in DialSlot.
  bool changed_ = false;
};

}  // namespace kaori::input
