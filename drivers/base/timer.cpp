#include "drivers/base/timer.h"

#include <sys/timerfd.h>

namespace kaori {
namespace {

timespec TimespecOf(Duration time) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
  return {.tv_sec = seconds.count(), .tv_nsec = (time - seconds).count()};
}

}  // namespace

// On CLOCK_MONOTONIC, as every time here, and non-blocking: a read before it is due gives EAGAIN.
Result<UniqueFd> OpenTimer(Duration first, Duration period, const char* attempt) {
  UniqueFd timer(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC));
  const itimerspec times{.it_interval = TimespecOf(period), .it_value = TimespecOf(first)};
  if (!timer.valid() || ::timerfd_settime(timer.get(), 0, &times, nullptr) != 0) return FailErrno(attempt);
  return timer;
}

}  // namespace kaori
