// What the stage shows to whoever services the box: lamps and lines that lead through a calibration, and the
// code by which a page is authorised. Nothing of it is seen in a show.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "drivers/base/clock.h"
#include "render/scene/scene.h"

namespace kaori::stage {

// True while a calibration is under way at the box; one whose program has been silent for half a second is
// over. Pure, as all of this file; `now` is the time at which the frame is presented.
bool IsGuiding(const board::Stamped<board::LipsGuide>& guide, Time now);

// The same of a line check, which ends with its stage.
bool IsChecking(const board::Stamped<board::LineCheck>& check, Time now);

// While a calibration is, presses of buttons, Enter and Escape are the calibration's, which reads them from
// the board itself: takes them out of `events`, so that nobody is called by them. Other keys still play.
// Dials and sticks are not touched.
void ConsumeGuideInput(performance::InputEvents& events);

// The lamps of buttons 1 to 4 are shut, open, wide, narrow: those that are taken are lit, the one that is
// asked for blinks, and faster while it is taken. When all are taken all four blink.
std::uint32_t GuideLamps(const board::LipsGuide& guide, Time now);

// Puts lines in front of what a caption shows.
void Say(const std::vector<std::string>& lines, scene::Caption& caption);

// Adds lines to the scene's caption: those of the calibration where the screen may show captions, else the
// line check while one runs, else the desk's
// address and code while they hold. A desk that has been silent for three seconds is gone.
void ShowService(const board::Snapshot& board, Time now, scene::Scene& scene);

}  // namespace kaori::stage
