// A simulated dial: of a dial box made by the kernel's uhid, or, where the kernel has none, written to the
// board itself.
#pragma once

#include <optional>

#include "appliance/core/board/board.h"

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::latency {

// One thread.
class SimulatedDial {
 public:
  // Plugs the box in. Errors: those of open(2) on /dev/uhid and of write(2).
  static Result<SimulatedDial> Open();
  // Instead of the input program. Errors: those of AcquireWriter.
  static Result<SimulatedDial> OnBoard(const board::Board& board);

  // Turns the dial by one count; the moment at which the device reported it. Errors: those of write(2).
  Result<Time> Turn(const Clock& clock);

  // Answers what the kernel asks of the device; to be called often.
  void Answer();

 private:
  explicit SimulatedDial(UniqueFd kernel) : kernel_(std::move(kernel)) {}
  explicit SimulatedDial(board::Writer<board::Surface> surface) : surface_(std::move(surface)) {}

  UniqueFd kernel_;
  std::optional<board::Writer<board::Surface>> surface_;
  board::Surface surface_state_;
};

}  // namespace kaori::latency
