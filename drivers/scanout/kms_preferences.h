// How people want a card's screens to be used, and which modes the card refused.
#pragma once

#include <xf86drmMode.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/clock.h"

namespace kaori::scanout {

// A mode that the card would not show on a connector, as with too little memory or
// a cable that is too long for it.
struct KmsRefusal {
  // KMS's number of the connector.
  std::uint32_t connector = 0;
  drmModeModeInfo mode{};
};

// The wishes come from the profile; the refusals are noted by KmsScreen and
// kept by KmsCard over all openings.
struct KmsPreferences {
  std::optional<drmModeModeInfo> mode;  // Of all screens; none: each has its own.
  // The connector of the status display, by its name ("HDMI-A-2") or by its number on the card, from 1.
  // Counts only where another screen shows the picture. Empty: there is no status display.
  std::string status_connector{};
  // That of the operators' monitor, in the same way. Where both name one screen it is the monitor.
  std::string monitor_connector{};

  // Modes that are not tried again while the screen is plugged in. Where nothing is left to show on, all of
  // them are forgotten a while after `refused_at`.
  std::vector<KmsRefusal> refused{};
  Time refused_at{};  // When a mode was refused last.
};

}  // namespace kaori::scanout
