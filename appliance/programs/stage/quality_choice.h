// How finely a stage draws: as it was told, or what its machine draws in time.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

// A quality, and why it: for the log.
struct ChosenQuality {
  passes::Quality quality = passes::Quality::kBasic;
  std::string why;
};

// The first of `finer`, finest first, whose frames are drawn in time, as `time` tells of each; one that the driver refuses is left out. Where
// there is none, basic, and what was wrong with the last one. Pure but for `time`.
ChosenQuality FirstInTime(std::span<const passes::Quality> finer,
                          const std::function<Result<std::vector<Duration>>(passes::Quality)>& time);

// "auto", "basic", "fine" or "finest".
bool IsQualityWish(std::string_view wish);
// For people whose option --quality names none of them.
std::string NoQualityWish(std::string_view wish);

// Has the studio draw as `wish` says, of those above; "auto" is what its driver can: basic on a processor; on a card
// the finest in which some frames of the show's first face, timed now, are drawn in time. Blocks for some 100 ms on a
// card. Returns the quality and why, for the log: "fine, 3.1 ms a frame". Where the driver refuses, what was set last stays.
std::string ChooseQuality(Studio& studio, std::string_view wish);

// Where "auto" was chosen for pictures of 1920 x 1080, and a screen that was just opened shows larger ones: the same again for its size, which
// a card may draw less finely. For other screens it is as it was. One thread.
class QualityForScreens {
 public:
  // Borrows the studio, whose quality is that for pictures of PictureSize{}.
  QualityForScreens(Studio& studio, std::string_view wish);

  // Of the screen's pictures. Blocks for some 100 ms on a card, and for longer where shaders are new; only the first time that a size
  // is seen. A screen that does not lend a picture yet, as the simulator's, changes nothing. What changes is logged.
  void See(ports::Scanout& screen);

 private:
  // At this size; never finer than for the usual one. Errors: what the driver says.
  Result<passes::Quality> QualityAt(PictureSize size);

  Studio& studio_;
  bool is_auto_;
  passes::Quality usual_;
  std::map<std::pair<int, int>, passes::Quality> at_size_;
};

}  // namespace kaori::stage
