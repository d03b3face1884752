#include "appliance/programs/stage/line_checker.h"

#include <algorithm>
#include <vector>

#include "appliance/core/board/keys.h"
#include "appliance/core/board/lines.h"
#include "appliance/core/linecheck/items.h"
#include "appliance/programs/stage/withheld.h"
#include "drivers/base/log.h"

namespace kaori::stage {
namespace {

namespace key = board::key;
using board::LineCheckCall;
using board::SourceState;

constexpr Duration kAbandoned = std::chrono::minutes(2);
constexpr Duration kScreensPeriod = std::chrono::seconds(1);

}  // namespace

const board::Snapshot& LineChecker::Step(const Frame& frame, performance::InputEvents& events) {
  const Wish wish = ReadWish(events, frame.now);
  const bool in_service = board::IsServiceKeyOn(frame.live.lines);
  if (wish == Wish::kBegin && !in_service)
    LogWarning("the line check does not begin: the service key is off");
  else if (wish == Wish::kBegin)
    Begin(frame);
  if (!check_.running()) return frame.snapshot;
  Look(frame);
  if (wish == Wish::kEnd)
    End("");
  else if (!in_service)
    End(", since the service key is off");
  else if (frame.now - check_.changed_at() >= kAbandoned)
    End(", since nothing was moved for two minutes");
  writer_.Write(check_.result(), frame.now, SourceState::kLive);
  left_ = frame.snapshot;
  // The log shall say of this frame how the check stands in it, and not in the one before.
  left_.line_check = {check_.result(), frame.now, SourceState::kLive};
  if (check_.running()) Withhold();
  ConsumeAll(events);  // Also in the last frame: what was pushed until the end is the check's.
  return left_;
}

// Calls of the check are its own, whether one runs or not. Without one Home alone is; the other keys play.
LineChecker::Wish LineChecker::ReadWish(performance::InputEvents& events, Time now) {
  Wish wish = Wish::kNone;
  events.ConsumeCalls([&](const board::Call& call) {
    if (call.verb != board::CallVerb::kLineCheck) return false;
    if (call.subject == static_cast<std::uint32_t>(LineCheckCall::kBegin)) wish = Wish::kBegin;
    if (call.subject == static_cast<std::uint32_t>(LineCheckCall::kEnd)) wish = Wish::kEnd;
    if (call.subject == static_cast<std::uint32_t>(LineCheckCall::kLampsWereLit)) check_.ConfirmLamps(now);
    return true;
  });
  events.Consume([&](const performance::Press& press) {
    if (!press.IsKey()) return false;
    if (press.code == key::kHome) wish = check_.running() ? Wish::kEnd : Wish::kBegin;
    if (!check_.running()) return press.code == key::kHome;
    if (press.code == key::kEscape) wish = Wish::kEnd;
    if (press.code == key::kEnter || press.code == key::kPadEnter) check_.ConfirmLamps(now);
    return true;
  });
  return wish;
}

void LineChecker::Begin(const Frame& frame) {
  screens_at_.reset();
  sound_ = frame.board.Read<board::Sound>();
  const linecheck::View view{frame.live, sound_, ScreensOf(frame)};
  check_.Begin(linecheck::ItemsFor(frame.show, frame.state.role_devices, frame.live, screen_count_), view,
               frame.now);
  Log("the line check begins: {} controls and devices; nothing of what is moved moves the face until it ends",
      check_.result().count);
}

void LineChecker::End(const char* why) {
  check_.End();
  Log("the line check has ended{}: {}", why, board::SummaryOf(check_.result()));
}

void LineChecker::Look(const Frame& frame) {
  sound_ = frame.board.Read<board::Sound>();
  check_.Look({frame.live, sound_, ScreensOf(frame)}, frame.now);
}

// An output that the show's picture or the status is on; one that is unplugged keeps its number.
std::uint32_t LineChecker::ScreensOf(const Frame& frame) {
  if (screens_at_ && frame.now - *screens_at_ < kScreensPeriod) return screens_;
  screens_at_ = frame.now;
  const auto outputs = frame.screen != nullptr ? frame.screen->outputs() : std::vector<ports::Output>();
  screen_count_ = std::min(outputs.size(), linecheck::kMostScreens);
  screens_ = 0;
  for (std::size_t n = 0; n < screen_count_; ++n)
    if (outputs[n].state != ports::OutputState::kUnplugged) screens_ |= 1U << n;
  return screens_;
}

// Devices that are absent move nothing. The lines stay: a blackout is black even now, and GO is a call.
void LineChecker::Withhold() {
  for (auto& stick : left_.sticks) stick.source = SourceState::kAbsent;
  left_.lips.source = left_.voice.source = SourceState::kAbsent;
  Release(left_);
}

}  // namespace kaori::stage
