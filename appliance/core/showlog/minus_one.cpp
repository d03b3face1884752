#include "appliance/core/showlog/minus_one.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

namespace kaori::showlog {
namespace {

// In the order of ForSections.
enum Section : std::size_t {
  kSurface,
  kLeftStick,
  kRightStick,
  kKeys,
  kLines,
  kInputCalls,
  kRemoteCalls,
  kPointer,
  kLips,
  kVoice,
  kLineCheck,  // Never laid: it is of this evening's box.
};
static_assert(kLineCheck + 1 == FrameTimes::kSections);

constexpr std::string_view kLipOperator = "lips";

// What was pressed or called on that evening was so much later by the clock of this play.
void MoveTimes(board::PressLog& log, Duration later) {
  const auto us = std::chrono::duration_cast<std::chrono::microseconds>(later).count();
  for (board::PressLog::Press& press : log.newest) press.at_us += static_cast<std::uint32_t>(us);
}
void MoveTimes(board::Surface& surface, Duration later) {
  MoveTimes(surface.log, later);
}
void MoveTimes(board::Stick& stick, Duration later) {
  MoveTimes(stick.log, later);
}
void MoveTimes(board::Keys& keys, Duration later) {
  MoveTimes(keys.log, later);
}
void MoveTimes(board::Calls& calls, Duration later) {
  for (board::Call& call : calls.newest) call.at += later;
}

}  // namespace

// Who plays a role was chosen on that evening, so that its state says it and not the show.
Result<MinusOne::Sections> MinusOne::LiveSections(const show::Show& show, const performance::State& state,
                                                  std::string_view role) {
  const auto& roles = show.roles.roles;
  const auto found = std::ranges::find(roles, role, &show::Role::name);
  if (found == roles.end() && role == kLipOperator) return Sections().set(kLips).set(kVoice);
  if (found == roles.end()) return FailInput(fmt::format("the show has no role \"{}\"", role));
  const std::uint8_t device = state.role_devices[static_cast<std::size_t>(found - roles.begin())];
  if (device == performance::kNoDevice)
    return FailInput(fmt::format("nobody played the role \"{}\" then", role));
  const bool dials = static_cast<show::Device>(device) == show::Device::kDialBox;
  return Sections().set(dials ? kSurface : kLeftStick + device);
}

// A chunk begins with a state; what lies between it and `at` is played, so that the state is that of `at`.
// Its first frame always is: the events of that one stand in the log, and do not follow from what was seen
// before.
Result<MinusOne> MinusOne::Open(const LogFile& log, const show::Show& show, Time at, std::string_view role) {
  MinusOne evening(log, show);
  Replay& replay = evening.replay_;
  replay.GoTo(at);
  performance::SeenInput seen;
  bool there = replay.Read();
  while (there) {
    replay.Make();
    seen = replay.seen();
    there = replay.Read();
    if (replay.presented_at() >= at) break;
  }
  if (!there && !replay.faults().empty()) return FailInput(replay.faults().front());
  if (!there)
    return FailInput(fmt::format("the log has nothing at {}; it begins at {}", log.DayTimeText(at),
                                 log.DayTimeText(log.chunks().front().head.first)));
  evening.state_ = replay.made().state;
  auto live = LiveSections(show, evening.state_, role);
  if (!live) return tl::unexpected(live.error());
  evening.live_ = *live;
  if (evening.live_[kSurface]) seen.surface_unknown = 1;
  for (std::size_t i = 0; i < seen.sticks_unknown.size(); ++i)
    if (evening.live_[kLeftStick + i]) seen.sticks_unknown[i] = 1;
  evening.state_.seen = seen;
  return evening;
}

const performance::State& MinusOne::Begin(Time presented_at) {
  later_ = presented_at - replay_.presented_at();
  state_.last += later_;
  for (Time& called_at : state_.seen.called_at) called_at += later_;
  return state_;
}

// Frames of the evening and of this play need not have one rate: the newest that is due is laid. Counters add
// up, so that no press between two of them is lost.
bool MinusOne::Lay(Time presented_at, board::Snapshot& board) {
  while (!over_ && replay_.presented_at() + later_ <= presented_at) {
    laid_ = replay_.board();
    over_ = !replay_.Read() || !replay_.follows();
  }
  if (over_) return false;
  const auto lay = [this](Section section, auto& into, const auto& from) {
    if (live_[section]) return;
    into = from;
    into.at += later_;
    if constexpr (requires { MoveTimes(into.value, later_); }) MoveTimes(into.value, later_);
  };
  lay(kSurface, board.surface, laid_.surface);
  lay(kLeftStick, board.sticks[0], laid_.sticks[0]);
  lay(kRightStick, board.sticks[1], laid_.sticks[1]);
  lay(kKeys, board.keys, laid_.keys);
  lay(kLines, board.lines, laid_.lines);
  lay(kInputCalls, board.calls[0], laid_.calls[0]);
  lay(kRemoteCalls, board.calls[1], laid_.calls[1]);
  lay(kPointer, board.pointer, laid_.pointer);
  lay(kLips, board.lips, laid_.lips);
  lay(kVoice, board.voice, laid_.voice);
  return true;
}

}  // namespace kaori::showlog
