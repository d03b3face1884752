#include "drivers/base/alarm.h"

#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>

namespace kaori {

Result<Alarm> Alarm::Make() {
  UniqueFd timer(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC));
  if (!timer.valid()) return FailErrno("create a timer");
  return Alarm(std::move(timer));
}

void Alarm::Set(Time at) {
  // A value of zero would disarm the timer (timerfd_settime(2)), so that the machine's
  // start itself is asked for as one nanosecond after it.
  const Duration since = std::max(at.time_since_epoch(), Duration(1));
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(since);
  const itimerspec once{{}, {seconds.count(), (since - seconds).count()}};
  ::timerfd_settime(timer_.get(), TFD_TIMER_ABSTIME, &once, nullptr);
}

void Alarm::Acknowledge() {
  // The descriptor is non-blocking: where nothing has expired, the read
  // fails with EAGAIN, and that is what is wanted.
  std::uint64_t rings = 0;
  [[maybe_unused]] const auto bytes = ::read(timer_.get(), &rings, sizeof(rings));
}

}  // namespace kaori
