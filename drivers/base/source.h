// What every reader of a device's stream does with its stamps.
#pragma once

#include "drivers/base/clock.h"

namespace kaori {

// Some sources stamp with another clock, or leap: UVC cameras derive their stamps from a clock of their
// own. A stamp in the future, or more than `oldest` before `now`, is replaced by the time of arrival,
// which is late by the transfer but never absurd. A plausible stamp is returned as it is.
inline Time PlausibleStamp(Time stamp, Time now, Duration oldest) {
  return stamp > now || stamp < now - oldest ? now : stamp;
}

}  // namespace kaori
