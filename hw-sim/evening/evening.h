// Plays a whole evening in the simulated system, as fast as this machine can, and says what came of it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "appliance/programs/stage/studio.h"
#include "drivers/base/result.h"
#include "hw-sim/evening/running_order.h"
#include "hw-sim/evening/verdict.h"

namespace kaori::sim {

// What an evening is played with; the defaults are those of kaori-evening.
struct EveningOptions {
  // The running order's name, for sentences.
  std::string file{};
  // For passing files and the show log; made if it is not there, emptied where it is.
  std::string folder{};
  // Of what operators do between the order's lines.
  std::uint64_t seed = 1;
  // False: nobody does anything but what the order's lines say.
  bool improvised = true;
  // Of the screen. Few pictures are drawn, since drawing takes nearly all of the time; each frame is
  // performed, logged and presented all the same.
  int width_px = 160, height_px = 90;
  double hz = 30;
  int draw_one_of = 120;
  // Called once a simulated second with what was reached until then; false: the evening stops there.
  std::function<bool(const Verdict& so_far)> tell{};
};

// Takes minutes of processor time. The studio serves one evening after another. The verdict tells of all that
// the evening did wrong. Errors are those that leave no evening: of the folder, the devices' links and the
// drawing.
Result<Verdict> PlayEvening(const RunningOrder& order, const EveningOptions& options, stage::Studio& studio);

}  // namespace kaori::sim
