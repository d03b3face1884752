// Transfers to a device that failed, of which a few in a whole evening are none.
#pragma once

#include <cstddef>
#include <vector>

#include "drivers/base/clock.h"

namespace kaori::input {

// Three within a minute are too many, and stay so until the device is plugged in again: it does not take what it is
// sent. One thread.
class TransferFailures {
 public:
  // One more. True: with it they are too many.
  bool Note(Time now) {
    std::erase_if(at_, [now](Time at) { return now - at >= kForgotten; });
    at_.push_back(now);
    return are_too_many();
  }
  bool are_too_many() const { return at_.size() == kTooMany; }

 private:
  static constexpr std::size_t kTooMany = 3;
  static constexpr Duration kForgotten = std::chrono::seconds(60);

  std::vector<Time> at_;
};

}  // namespace kaori::input
