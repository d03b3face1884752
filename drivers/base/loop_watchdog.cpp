#include "drivers/base/loop_watchdog.h"

#include <algorithm>
#include <utility>

#include "drivers/base/log.h"
#include "drivers/base/service.h"

namespace kaori::service {
namespace {

// A single late beat, as while a device is opened, is no pace: Watchdog::kPatientTurns as long would be no limit at all.
constexpr int kPatientBeats = 3;

}  // namespace

Duration BeatPace::See(Time now) {
  if (!std::exchange(seen_, true)) {
    window_began_ = last_ = now;
    return {};
  }
  if (now - window_began_ >= kWindow) {
    longest_before_ = std::exchange(longest_, Duration{});
    window_began_ = now;
  }
  longest_ = std::max(longest_, now - std::exchange(last_, now));
  const Duration silence = std::max(kLeastSilence, std::max(longest_, longest_before_) * kPatientBeats);
  return (silence + Duration(Watchdog::kPatientTurns - 1)) / Watchdog::kPatientTurns;  // Rounded up.
}

Result<void> FeedWatchdog(EventLoop& loop, std::function<Duration()> turn) {
  auto watchdog = Watchdog::Wanted();
  if (!watchdog) return {};
  return loop.Every(Watchdog::kPeriod, [watchdog = *watchdog, turn = std::move(turn)]() mutable {
    if (auto told = watchdog.Beat(turn()); !told) LogWarning("{}", told.error().message());
  });
}

Result<void> FeedWatchdog(EventLoop& loop, const Clock& clock) {
  return FeedWatchdog(loop, [pace = BeatPace(), &clock]() mutable { return pace.See(clock.now()); });
}

// A turn of 0 asks for the longest silence.
Result<void> FeedWatchdogOfUnit(EventLoop& loop) {
  constexpr int kBeatsInLimit = 4;
  auto watchdog = Watchdog::Wanted();
  if (!watchdog) return {};
  const auto beat = [watchdog = *watchdog]() mutable {
    if (auto told = watchdog.Beat({}); !told) LogWarning("{}", told.error().message());
  };
  std::function<void()> again = beat;
  again();
  return loop.Every(watchdog->limit() / kBeatsInLimit, std::move(again));
}

}  // namespace kaori::service
