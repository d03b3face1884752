// How often something happens in a second, from a counter that is looked at now and then.
#pragma once

#include <cstdint>

#include "drivers/base/clock.h"

namespace kaori::console {

// Pure. Good for display: its value is that of the last whole second or more.
class Rate {
 public:
  // `count` is a counter that only grows. It is looked at again after a second at the soonest.
  void See(std::uint64_t count, Time now) {
    const Duration since = now - at_;
    if (since < std::chrono::seconds(1)) return;
    per_s_ = at_ == Time{} ? 0 : static_cast<double>(count - count_) / Seconds(since);
    count_ = count;
    at_ = now;
  }
  // In a second; 0 before two looks.
  double per_s() const { return per_s_; }

 private:
  // The counter at the last look.
  std::uint64_t count_ = 0;
  Time at_{};
  double per_s_ = 0;
};

}  // namespace kaori::console
