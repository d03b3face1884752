// Chooses the mode in which a screen is shown.
#pragma once

#include <xf86drmMode.h>

#include <optional>
#include <span>
#include <string_view>

#include "drivers/base/clock.h"
#include "drivers/ports/output.h"

namespace kaori::scanout {

// A mode, and how it came about.
struct ChosenMode {
  // Timings and size, as KMS wants them in a blob.
  drmModeModeInfo mode{};
  // Why it is this mode, for people.
  ports::ModeOrigin origin = ports::ModeOrigin::kSafeGuess;
};

// The mode that the screen's EDID prefers. A screen that prefers none (its EDID is broken or
// missing) gets the largest progressive mode up to 1920 x 1080, which every cable carries, or
// else its first mode. A screen without modes gets 640 x 480 at 60 Hz, which every screen shows.
// Modes without pixels, or beyond 16384 pixels a side, are passed over. The rate is that of the
// mode: 50 Hz are not preferred to 60. Pure.
ChosenMode ChooseMode(std::span<const drmModeModeInfo> modes);

// A mode that people ask for, as in "1280x720@50", timed by VESA's CVT 1.2 with reduced blanking: most
// flat screens accept it, whether or not their EDID lists it. None where `text` is no mode, or is
// beyond 16384 pixels a side or 1000 Hz. Pure.
std::optional<drmModeModeInfo> ParseMode(std::string_view text);

// From one vertical blank to the next: htotal * vtotal pixels at `clock` kHz; 1/60 s
// where the mode has no pixel clock. Pure.
Duration PeriodOf(const drmModeModeInfo& mode);

}  // namespace kaori::scanout
