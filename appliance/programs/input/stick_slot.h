// The slot of a joystick: axes and buttons go to the board, with what holds while the stick is unplugged.
#pragma once

#include <optional>
#include <string>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/carried_switches.h"
#include "appliance/programs/input/device_slot.h"
#include "appliance/programs/input/settings.h"
#include "drivers/decode/joystick.h"

namespace kaori::input {

// Whether the board shows nothing that a silent stick would contradict. The slider has no rest.
bool IsAtRest(const board::Stick& stick);

// A stick that is pulled leaves its axes on the board and makes the section stale; the stage then eases them
// to neutral. After a plug the section stays stale until the first report, or until that ease is over: from
// then on a stick that reports nothing is one at rest. So the face never jumps.
class StickSlot final : public DeviceSlot {
 public:
  // `which` is the section of the board: 0 left, 1 right. The board is not kept. The settings are copied:
  // dead zone, reach and curve go to the decoder at each plug.
  StickSlot(const board::Board& board, board::Writer<board::Stick> writer, int which,
            const InputSettings& settings);

  std::string_view name() const override { return which_ == 0 ? "left stick" : "right stick"; }
  Result<void> Plug(const ports::HidIdentity& identity, Time now) override;
  Result<void> Accept(std::span<const std::uint8_t> report, Time at) override;
  void Publish() override;
  void Unplug(Time now) override;
  void Tick(Time now, ports::HidChannel* device) override;

 private:
  // Takes the stick's position as its centre when the centre button went down.
  void CalibrateOnPush(const decode::StickSample& sample);
  // Publishes the section with this stamp and state.
  void Write(Time at, board::SourceState source);

  board::Writer<board::Stick> writer_;
  int which_;
  decode::StickSettings settings_;
  int centre_button_;                // Counted from 1; 0: there is none.
  std::uint32_t centre_pushes_ = 0;  // Of the centre button, since the plug.
  board::Stamped<board::Stick> stick_;
  CarriedSwitches<1> buttons_;
  std::optional<decode::JoystickDecoder> decoder_;
  // When the stick was plugged in, from which the waits of Tick count.
  Time plugged_{};
  bool reported_ = false;  // A report arrived since the plug, or the stick counts as one at rest.
  bool changed_ = false;
};

}  // namespace kaori::input
