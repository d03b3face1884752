// What every reader of a device's stream does: it opens the device until it is there, and checks its stamps.
#pragma once

#include <functional>
#include <memory>
#include <system_error>

#include "drivers/base/clock.h"
#include "drivers/base/log.h"
#include "drivers/base/result.h"

namespace kaori {

// Opens a device, or returns null and logs why: once for each cause, however often it is tried. `logged` is
// the cause that was logged last. The caller keeps it and may set it: to std::errc{} once the device
// delivers, so that its next absence is logged, or to the cause that a line of its own has just told. Blocks
// for as long as `open`.
template <class Device>
std::unique_ptr<Device> OpenOrLog(const std::function<Result<std::unique_ptr<Device>>()>& open,
                                  std::errc& logged) {
  auto device = open();
  if (device) return std::move(*device);
  if (logged != device.error().cause) Log("{}; trying again until it is there", device.error().message());
  logged = device.error().cause;
  return nullptr;
}

// Some sources stamp with another clock, or leap: UVC cameras derive their stamps from a clock of their
// own. A stamp in the future, or more than `oldest` before `now`, is replaced by the time of arrival,
// which is late by the transfer but never absurd. A plausible stamp is returned as it is.
inline Time PlausibleStamp(Time stamp, Time now, Duration oldest) {
  return stamp > now || stamp < now - oldest ? now : stamp;
}

}  // namespace kaori
