// What the agent sees of the box: its board, as JSON.
#pragma once

#include <string>

#include "appliance/core/board/board.h"
#include "drivers/base/clock.h"

namespace kaori::agent {

// Every section that a bench looks at, whether a program holds the right to write it now, and the machine's clock in ns. Of a
// file that took the place of another the board is opened anew: this one's writers are those of its own file.
std::string BoardAsJson(const board::Board& board, const Clock& clock);

// Looks as fast as it can for `length`, and tells of every change of the left stick ("stick AT_NS X") and of
// every frame that was presented ("flip READ_NS FLIP_NS"), a line each.
std::string WatchEvents(const board::Board& board, const Clock& clock, Duration length);

}  // namespace kaori::agent
