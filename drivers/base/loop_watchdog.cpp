#include "drivers/base/loop_watchdog.h"

#include <algorithm>
#include <utility>

#include "drivers/base/log.h"
#include "drivers/base/service.h"

namespace kaori::service {

Duration BeatPace::See(Time now) {
  if (!std::exchange(seen_, true)) window_began_ = last_ = now;
  if (now - window_began_ >= kWindow) {
    longest_before_ = std::exchange(longest_, Duration{});
    window_began_ = now;
  }
  longest_ = std::max(longest_, now - std::exchange(last_, now));
  return std::max(longest_, longest_before_);
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

}  // namespace kaori::service
