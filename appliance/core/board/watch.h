// A program's board is looked after while its loop runs.
#pragma once

#include "appliance/core/board/board.h"
#include "drivers/base/event_loop.h"

namespace kaori::board {

// Calls Board::Heal every kHealPeriod, and logs once when the board was replaced and once for each new reason
// why it cannot be. The board must outlive the loop's Run. Errors: those of EventLoop::Every. Runs on the
// loop's thread, which is that of the board and of its writers. A board that cannot be mended ends nothing: the program
// goes on by what it has, and tries again at the next look.
Result<void> Watch(Board& board, EventLoop& loop);

}  // namespace kaori::board
