// What every reader of a device's stream does: it opens the device until it is there, and doubts its stamps.
#pragma once

#include <functional>
#include <memory>
#include <system_error>

#include "drivers/base/clock.h"
#include "drivers/base/log.h"
#include "drivers/base/result.h"

namespace kaori {

// Nothing where it cannot be opened now: that is logged, once for each cause, however often it is tried.
// `logged` is the cause that was logged last.
template <class Device>
std::unique_ptr<Device> OpenOrSay(const std::function<Result<std::unique_ptr<Device>>()>& open,
                                  std::errc& logged) {
  auto device = open();
  if (device) return std::move(*device);
  if (logged != device.error().cause) Log("{}; trying again until it is there", device.error().message());
  logged = device.error().cause;
  return nullptr;
}

// Some sources stamp with another clock, or leap: then the arrival is the better guess.
inline Time Believable(Time stamp, Time now, Duration oldest) {
  return stamp > now || stamp < now - oldest ? now : stamp;
}

}  // namespace kaori
