// The service key, for programs that only want to know whether somebody works at the box.
#pragma once

#include <string>

#include "appliance/core/board/board.h"
#include "appliance/core/board/lines.h"

namespace kaori::board {

// Whether the key is on now, by the board at `path`; false where there is none, and while the line is not heard
// of. The board is opened for each look, and not made: one that was made anew in the meantime has to be found.
// Blocks for the file system. Any thread.
inline bool IsServiceKeyOnAt(const std::string& path) {
  const auto board = Board::Open(path);
  return board && IsServiceKeyOn(board->Read<Lines>());
}

}  // namespace kaori::board
