// In which mode a screen is shown.
#pragma once

#include <xf86drmMode.h>

#include <optional>
#include <span>
#include <string_view>

#include "drivers/base/clock.h"

namespace kaori::scanout {

struct ChosenMode {
  drmModeModeInfo mode{};
  bool wished = false;   // By the screen, or by people; else it is a safe guess.
  bool instead = false;  // The card refused a better one.
};

// The mode that the screen asks for by its EDID; of a screen that asks for none (a broken EDID, or none at
// all) the largest one that every cable carries, up to 1920 x 1080; where there are none at all, 640 x 480,
// which every screen takes.
ChosenMode ChooseMode(std::span<const drmModeModeInfo> modes);

// A mode of people's own, as in "1280x720@50", timed as VESA's CVT does with reduced blanking. None where the
// words are no mode, or one that no card has.
std::optional<drmModeModeInfo> ParseMode(std::string_view words);

// From one vertical blank to the next; 60 Hz where the mode does not say.
Duration PeriodOf(const drmModeModeInfo& mode);

}  // namespace kaori::scanout
