// How people want a card's screens to be used, and what the card refused of it.
#pragma once

#include <xf86drmMode.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/clock.h"

namespace kaori::scanout {

// A mode that the card would not show on a connector.
struct KmsRefusal {
  std::uint32_t connector = 0;
  drmModeModeInfo mode{};
};

struct KmsWishes {
  std::optional<drmModeModeInfo> mode;  // Of all screens; else each in its own.
  // The screen that is a sign, wherever another one shows the picture: by its connector's name ("HDMI-A-2"),
  // or by its number on the card, from 1.
  std::string sign{};

  std::vector<KmsRefusal> refused{};  // Not tried again while the screen is plugged in,
  Time refused_at{};                  // but for a card that then shows nothing at all: a while after this.
};

}  // namespace kaori::scanout
