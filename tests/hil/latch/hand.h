// A hand on a dial: of a dial box that the kernel takes for a real one (uhid), or, where there is no such
// kernel, right on the board.
#pragma once

#include <optional>

#include "appliance/core/board/board.h"

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::latch {

// One thread.
class Hand {
 public:
  // Plugs the box in. Errors: those of open(2) on /dev/uhid and of write(2).
  static Result<Hand> Open();
  // In the input program's place. Errors: those of AcquireWriter.
  static Result<Hand> OnBoard(const board::Board& board);

  // Turns the dial by one count; the moment at which the device reported it. Errors: those of write(2).
  Result<Time> Turn(const Clock& clock);

  // Answers what the kernel asks of the device; to be called often.
  void Answer();

 private:
  explicit Hand(UniqueFd kernel) : kernel_(std::move(kernel)) {}
  explicit Hand(board::Writer<board::Surface> surface) : surface_(std::move(surface)) {}

  UniqueFd kernel_;
  std::optional<board::Writer<board::Surface>> surface_;
  board::Surface stands_;
};

}  // namespace kaori::latch
