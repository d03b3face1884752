// Calls on the board in the words of a page: "goto 14", "standby 2.10", "level 8 0.25", "letgo 8", "load 1
// 0", "check 1", "learn 1 8", "lock 1", "motion 3 1". Levels, roles, motions and devices are counted from 0, as board::Call has them. For the
// page that people look at: it stands where a remote control will.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "appliance/core/board/caller.h"
#include "drivers/base/clock.h"

namespace kaori::sim {

// The one writer of CallWriter::kControl. One thread.
class StageCaller {
 public:
  // `board` is the file that the box's programs share; it is made where it is not there. Borrows the clock.
  StageCaller(std::string board, const Clock& clock) : path_(std::move(board)), clock_(clock) {}

  // Makes the call that `line` says; what it names need not be known here. Blocks for the file system.
  // Errors:
  //   invalid_argument  the line is no call; the attempt names what is wrong (kInput)
  //   those of Board::Create, Board::Heal and Caller::Acquire
  Result<void> Call(std::string_view line);

 private:
  Result<void> Open();

  std::string path_;
  const Clock& clock_;
  std::optional<board::Board> board_;
  // Of the board above.
  std::optional<board::Caller> caller_;
};

}  // namespace kaori::sim
