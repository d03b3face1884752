// The dial and button box: counts and pushes to the board, lamps back to the box.
#pragma once

#include <optional>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/carried_switches.h"
#include "appliance/programs/input/seat.h"
#include "drivers/decode/dial_box.h"

namespace kaori::input {

class DialSeat final : public Seat {
 public:
  // Borrows the board, whose lamps it shows.
  DialSeat(const board::Board& board, board::Writer<board::Surface> writer, int counts_per_turn);

  std::string_view name() const override { return "dial box"; }
  Result<void> Plug(const ports::HidIdentity& identity, Time now) override;
  Result<void> Accept(std::span<const std::uint8_t> report, Time at) override;
  void Publish() override;
  void Unplug(Time now) override;
  void Tick(Time now, ports::HidChannel* device) override;

 private:
  void ShowLamps(Time now, ports::HidChannel& device);
  void Write();

  const board::Board& board_;
  board::Writer<board::Surface> writer_;
  board::Stamped<board::Surface> surface_;
  CarriedSwitches<1> buttons_;
  std::optional<decode::DialBoxDecoder> decoder_;
  std::optional<std::uint32_t> lit_;  // What the box was last told; nothing after a plug: it is dark then.
  Time lamps_after_{};                // Not to be told before; and how often telling failed since the plug.
  int lamp_failures_ = 0;
  Time plugged_{};
  bool proven_ = true;  // False while what is held stands there from before the plug.
  bool changed_ = false;
};

}  // namespace kaori::input
