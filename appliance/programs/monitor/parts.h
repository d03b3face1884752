// The parts of the monitor's page: cues, lips, what is on, and levels. Each adds its cells, always the same
// number of them for a size.
#pragma once

#include <vector>

#include "appliance/programs/monitor/cells.h"

namespace kaori::monitor {

// The cue that stands by, with what GO does, and below it the one that is active, with what comes by itself.
void AddCues(const View& view, const Pen& pen, Box box, std::vector<Cell>& cells);

// The mouth in words, how far it is open, and how loud the voice is, with the threshold above which it moves the mouth.
// Gives where the lip camera's picture lies.
Box AddLips(const View& view, const Pen& pen, Box box, std::vector<Cell>& cells);

// Face, expression, scene, drawing and motions, each with how far its fade or its length has come.
void AddPlaying(const View& view, const Pen& pen, Box box, std::vector<Cell>& cells);

// The roles, and a bar for each level. Where there is no room for all, those that nobody has are left out
// first.
void AddLevels(const View& view, const Pen& pen, Box box, std::vector<Cell>& cells);

}  // namespace kaori::monitor
