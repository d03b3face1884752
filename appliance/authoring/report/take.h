// A take: what the operators did in a stretch of an evening, as a registered motion that keys and cues play.
#pragma once

#include <string>

#include "appliance/core/show/show.h"
#include "appliance/core/showlog/log_file.h"
#include "drivers/base/result.h"

namespace kaori::authoring {

struct TakeOptions {
  std::string name;
  Time from{};
  Duration length{};
  float gain = 1;        // Of all that moves: 0.1 to 2.
  float stretch = 1;     // Of its time: 0.25 to 4; 2 is half as fast.
  float ease_s = 0.25F;  // In and out, after stretching: a motion begins and ends at rest.
};

// How far a curve may lie from what was recorded, in radians or weights, where keys are left out.
inline constexpr float kTakeError = 5e-5F;

// Plays the log from there and keeps what sticks did to head, gaze and brows; the mouth is the lips' own, and what does not
// move has no curve. Errors: kInput: the log has nothing there, has a gap in the stretch, or nothing moved.
Result<show::Motion> RecordTake(const showlog::LogFile& log, const show::Show& show,
                                const TakeOptions& options);

// As it stands in show.toml: [[motion]], angles in degrees. Curves are named as kaori-atelier reads them.
std::string TextOfTake(const show::Motion& motion, const show::Show& show);

}  // namespace kaori::authoring
