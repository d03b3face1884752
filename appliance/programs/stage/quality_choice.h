// How finely a stage draws: as it was told, or what its machine draws in time.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "appliance/programs/stage/studio.h"
#include "drivers/base/clock.h"
#include "drivers/ports/scanout.h"
#include "render/passes/quality.h"

namespace kaori::stage {

// A picture, in pixels.
struct PictureSize {
  int width_px = 1920;
  int height_px = 1080;
};

// A frame may take as long, so that 60 in a second leave a third of the time to all else.
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
std::string ChooseQuality(Studio& studio, std::string_view wish, PictureSize size = {});

// The same anew where a screen that was just opened shows larger pictures than were timed: a card may draw finely for a screen
// of 1920 x 1080, and not for one of four times as many pixels. One thread.
class QualityForScreens {
 public:
  // Borrows the studio, whose quality is chosen for pictures of PictureSize{}.
  QualityForScreens(Studio& studio, std::string wish) : studio_(studio), wish_(std::move(wish)) {}

  // Of the screen's pictures. A screen that does not lend one yet changes nothing. What is chosen is logged.
  void See(ports::Scanout& screen);

 private:
  Studio& studio_;
  std::string wish_;
  long timed_px_ = 1920L * 1080;
};

}  // namespace kaori::stage
