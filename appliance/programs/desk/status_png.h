// The box's status picture for the page.
#pragma once

#include <string>

#include "appliance/core/board/board.h"
#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::desk {

// A PNG, as large as a page shows it; takes tens of milliseconds. What the stage says of its screens lies
// beside the board. Errors: not_enough_memory, io_error.
Result<std::string> StatusPng(const board::Board& board, Time now);

}  // namespace kaori::desk
