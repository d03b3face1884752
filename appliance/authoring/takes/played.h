// How a take is played: its curves as those of a motion, eased in and out, and closed to a loop.
#pragma once

#include <vector>

#include "appliance/authoring/takes/take.h"

namespace kaori::authoring {

// The value of a recording's curve, in the file's unit; at its last key too, and 0 outside of it.
float RecordedAt(const std::vector<show::MotionKey>& keys, float at_s);

// A curve as it is played, in radians, metres or weights and in seconds of playing: begins and, unless the
// take loops, ends at 0, and so does a curve that is shorter than its take. Empty: the curve lies outside of
// what is played. Where neither easing nor the seam of a loop reaches, its keys are those of the recording.
// Pure.
std::vector<show::MotionKey> PlayedKeys(const Take& take, const TakeCurve& curve);

// Where it loops, as show::Motion has it. Both 0: it does not.
struct TakeLoop {
  float from_s = 0, to_s = 0;
};
TakeLoop LoopOf(const Take& take);

}  // namespace kaori::authoring
