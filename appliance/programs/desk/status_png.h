// The status picture of the box for the page.
#pragma once

#include <string>

#include "appliance/core/board/board.h"
#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::desk {

// Draws the status as a PNG as large as the page shows it, which needs tens of milliseconds. The stage's file
// of screens lies beside the board. Errors:
//   not_enough_memory, io_error  the picture could not be encoded
// It is drawn anew for each request.
Result<std::string> StatusPng(const board::Board& board, Time now);

}  // namespace kaori::desk
