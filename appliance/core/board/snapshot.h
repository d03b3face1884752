// Everything that the stage needs of the board, read at one moment.
#pragma once

#include <array>

#include "appliance/core/board/board.h"

namespace kaori::board {

struct Snapshot {
  Stamped<Surface> surface;
  std::array<Stamped<Stick>, 2> sticks;  // [0] left (head), [1] right (gaze and brows).
  Stamped<Keys> keys;
  Stamped<Lines> lines;
  Stamped<Pointer> pointer;
  Stamped<Lips> lips;
  Stamped<Voice> voice;
  Stamped<LipsGuide> lips_guide;
  Stamped<Desk> desk;
  Stamped<Lamps> lamps;
  Stamped<StageStatus> stage_status;
};

// Each section is whole and valid in itself; two sections may be a few hundred nanoseconds apart. Never
// waits. `performance` is not among them: its owner reads it once, at its start.
Snapshot ReadAll(const Board& board);

}  // namespace kaori::board
