// A joystick: axes and buttons to the board, and what they are worth while the stick is away.
#pragma once

#include <optional>
#include <string>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/carried_switches.h"
#include "appliance/programs/input/seat.h"
#include "appliance/programs/input/settings.h"
#include "drivers/decode/joystick.h"

namespace kaori::input {

// A stick that is pulled leaves its axes on the board and makes the section stale: the stage eases them to
// neutral. After a re-plug the section stays stale until a fresh report, or until that ease is over: from
// then on a silent stick is one at rest. So nothing ever jumps.
class StickSeat final : public Seat {
 public:
  // `which` as on the board: 0 left, 1 right.
  StickSeat(const board::Board& board, board::Writer<board::Stick> writer, int which,
            const InputSettings& settings);

  std::string_view name() const override { return which_ == 0 ? "left stick" : "right stick"; }
  Result<void> Plug(const ports::HidIdentity& identity, Time now) override;
  Result<void> Accept(std::span<const std::uint8_t> report, Time at) override;
  void Publish() override;
  void Unplug(Time now) override;
  void Tick(Time now, ports::HidChannel* device) override;

 private:
  void TakeCentre(const decode::StickSample& sample);
  void Write(Time at, board::SourceState source);

  board::Writer<board::Stick> writer_;
  int which_;
  decode::StickSettings settings_;
  int centre_button_;                // From 1; 0: none.
  std::uint32_t centre_pushes_ = 0;  // Of that button, since the plug.
  board::Stamped<board::Stick> stick_;
  CarriedSwitches<1> buttons_;
  std::optional<decode::JoystickDecoder> decoder_;
  Time plugged_{};
  bool fresh_ = false;  // A report came since the plug.
  bool changed_ = false;
};

}  // namespace kaori::input
