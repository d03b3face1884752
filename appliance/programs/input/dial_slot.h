// The slot of the dial and button box: counts and pushes go to the board, lamps from the board to the box.
// Firmware of the box: firmware/wire has the bytes of its reports.
#pragma once

#include <optional>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/carried_switches.h"
#include "appliance/programs/input/device_slot.h"
#include "drivers/decode/dial_box.h"

namespace kaori::input {

// Counts accumulate over plugs and restarts: turning an unplugged box moves nothing, and a box that is
// plugged in again goes on where its dials stood on the board.
class DialSlot final : public DeviceSlot {
 public:
  // Borrows the board, which outlives the slot and whose section Lamps the box shows. `counts_per_turn` is
  // how many counts one turn of a dial gives.
  DialSlot(const board::Board& board, board::Writer<board::Surface> writer, int counts_per_turn);

  std::string_view name() const override { return "dial box"; }
  Result<void> Plug(const ports::HidIdentity& identity, Time now) override;
  Result<void> Accept(std::span<const std::uint8_t> report, Time at) override;
  void Publish() override;
  void Unplug(Time now) override;
  void Tick(Time now, ports::HidChannel* device) override;

 private:
  // Sends one output report where the lamps on the board differ from those that the box was last told, and one
  // each second.
  void ShowLamps(Time now, ports::HidChannel& device);
  // Publishes the section as it is, with the carried buttons.
  void Write();

  const board::Board& board_;
  board::Writer<board::Surface> writer_;
  // The section as it was published last, but for buttons, which buttons_ has.
  board::Stamped<board::Surface> surface_;
  CarriedSwitches<1> buttons_;
  std::optional<decode::DialBoxDecoder> decoder_;
  std::optional<std::uint32_t> lit_;  // As the box was last told; empty after a plug, when all are dark.
  Time told_{};                       // And when.
  Time lamps_after_{};                // No lamp report is sent before this time.
  int lamp_failures_ = 0;             // Since the plug.
  // When the box was plugged in, from which kHeldStateTrust counts.
  Time plugged_{};
  bool held_confirmed_ = true;  // False while held buttons are known only from before the plug.
  // A report was accepted that is not published yet.
  bool changed_ = false;
};

}  // namespace kaori::input
