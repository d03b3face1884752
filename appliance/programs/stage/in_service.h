// What the stage does for whoever works at the box: lamps and lines that lead through a calibration, and the
// code that lets a page in. Nothing of it is seen in a show.
#pragma once

#include <cstdint>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "drivers/base/clock.h"
#include "render/scene/scene.h"

namespace kaori::stage {

// A calibration is under way at the box; one whose program is silent for half a second is none.
bool IsGuiding(const board::Stamped<board::LipsGuide>& guide, Time now);

// While it is, presses of buttons, Enter and Escape are the calibration's, which reads them from the board itself:
// takes them out of `events`, so that nobody is called by them.
void ConsumeGuideInput(performance::InputEvents& events);

// The lamps of buttons 1 to 4 are shut, open, wide, narrow: those that are taken are lit, the one that is
// asked for blinks, and faster while it is taken. When all are taken all four blink.
std::uint32_t GuideLamps(const board::LipsGuide& guide, Time now);

// Adds the lines to the scene's caption: of the calibration where the screen may speak, else the desk's
// address and code while they hold. A desk that is silent for three seconds is none.
void SayService(const board::Snapshot& board, Time now, scene::Scene& scene);

}  // namespace kaori::stage
