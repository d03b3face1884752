#include "appliance/core/performance/lock.h"

#include <algorithm>
#include <span>

#include "appliance/core/board/lines.h"
#include "appliance/core/performance/kept.h"

namespace kaori::performance {
namespace {

// What keeps an evening going, and what saves it. STOP and PAUSE are not among them: a stray key would hold
// the show.
bool KeepsTheShow(std::uint32_t verb) {
  switch (static_cast<show::CueVerb>(verb)) {
    case show::CueVerb::kGo:
    case show::CueVerb::kBack:
    case show::CueVerb::kPanic:
    case show::CueVerb::kBlackout:
      return true;
    case show::CueVerb::kStop:
    case show::CueVerb::kPause:
      break;
  }
  return false;
}

bool KeepsTheShow(const show::Call& call) {
  return call.kind == show::CallKind::kCue && KeepsTheShow(call.index);
}

// Whether a role is played from the device that has this button.
bool IsPlayed(std::size_t button, const State& state, const show::Roles& roles) {
  constexpr std::size_t kBox = show::kButtonCount;
  const show::Device device = button < kBox                             ? show::Device::kDialBox
                              : button < kBox + show::kStickButtonCount ? show::Device::kLeftStick
                                                                        : show::Device::kRightStick;
  const auto devices = std::span(state.role_devices).first(roles.roles.size());
  return std::ranges::find(devices, static_cast<std::uint8_t>(device)) != devices.end();
}

}  // namespace

// A button that calls nothing is not refused: nobody asked for anything.
bool IsLockedOut(const State& state, const Press& press, const show::Show& show) {
  if (state.locked == 0) return false;
  if (!press.IsKey()) {
    const show::Call& call = ButtonOf(state, show, press.code);
    return call.kind != show::CallKind::kNothing && !KeepsTheShow(call) &&
           !IsPlayed(press.code, state, show.roles);
  }
  return std::ranges::none_of(show.keys, [&](const show::KeyCall& key) {
    return key.key_usage == press.code && KeepsTheShow(key.call);
  });
}

// The lock itself is asked for by a call, and so is a line check, which the stage has taken out.
bool IsLockedOut(const State& state, const board::Call& call) {
  if (state.locked == 0) return false;
  if (call.verb == board::CallVerb::kCue) return !KeepsTheShow(call.subject);
  return call.verb != board::CallVerb::kLock;
}

bool IsLockedOut(const State& state, const show::Call& call) {
  return state.locked != 0 && !KeepsTheShow(call);
}

void NoteLockedOut(State& state, const Press* press) {
  ++state.locked_out;
  if (press == nullptr || press->IsKey()) return;
  state.locked_out_button = press->code;
  state.since_locked_out_s = 0;
}

void Lock(State& state) {
  state.locked = 1;
}

void FollowServiceKey(State& state, bool was_locked, const board::Stamped<board::Lines>& lines) {
  if (state.locked == 0 || !board::IsServiceKeyOn(lines)) return;
  state.locked = 0;
  if (!was_locked) ++state.locks_denied;
}

}  // namespace kaori::performance
