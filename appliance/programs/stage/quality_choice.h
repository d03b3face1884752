// How finely a stage draws: as it was told, or what its machine draws in time.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "appliance/programs/stage/studio.h"
#include "drivers/base/clock.h"
#include "render/passes/quality.h"

namespace kaori::stage {

// A frame of 1920 x 1080 may take as long, so that 60 in a second leave a third of the time to all else.
inline constexpr Duration kFineFrame = std::chrono::milliseconds(11);

// Whether frames that took these times, in any order, are drawn in time: their median is within kFineFrame. False of
// none.
bool IsInTime(std::span<const Duration> times);

// "auto", "basic", "fine" or "finest".
bool IsQualityWish(std::string_view wish);
// For people whose option --quality names none of them.
std::string NoQualityWish(std::string_view wish);

// Has the studio draw as `wish` says, of those above; "auto" is what its driver can: basic on a processor; on a card
// the finest in which some frames of the show's first face, timed now, are drawn in time. Blocks for some 100 ms on a
// card. Returns the quality and why, for the log: "fine, 3.1 ms a frame". Where the driver refuses, what was set last stays.
std::string ChooseQuality(Studio& studio, std::string_view wish);

}  // namespace kaori::stage
