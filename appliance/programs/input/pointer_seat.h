// The mouse or tablet: a place on the picture, buttons and a wheel to the board.
#pragma once

#include <optional>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/carried_switches.h"
#include "appliance/programs/input/seat.h"
#include "drivers/decode/pointer.h"

namespace kaori::input {

// The place holds while nothing is plugged in, and over restarts of the program.
class PointerSeat final : public Seat {
 public:
  PointerSeat(const board::Board& board, board::Writer<board::Pointer> writer,
              const decode::PointerSettings& settings);

  std::string_view name() const override { return "pointer"; }
  Result<void> Plug(const ports::HidIdentity& identity, Time now) override;
  Result<void> Accept(std::span<const std::uint8_t> report, Time at) override;
  void Publish() override;
  void Unplug(Time now) override;
  void Tick(Time now, ports::HidChannel* device) override;

 private:
  void Write();

  board::Writer<board::Pointer> writer_;
  decode::PointerSettings settings_;
  board::Stamped<board::Pointer> pointer_;
  CarriedSwitches<1> buttons_;
  std::optional<decode::PointerDecoder> decoder_;
  Time plugged_{};
  bool proven_ = true;  // As in DialSeat.
  bool changed_ = false;
};

}  // namespace kaori::input
