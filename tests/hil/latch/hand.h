// A dial box that the kernel takes for a real one (uhid), and the hand on its first dial.
#pragma once

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::hil {

// One thread.
class Hand {
 public:
  // Plugs the box in. Errors: those of open(2) on /dev/uhid and of write(2).
  static Result<Hand> Open();

  // Turns the dial by one count; the moment at which the device reported it. Errors: those of write(2).
  Result<Time> Turn(const Clock& clock);

  // Answers what the kernel asks of the device; to be called often.
  void Answer();

 private:
  explicit Hand(UniqueFd kernel) : kernel_(std::move(kernel)) {}

  UniqueFd kernel_;
};

}  // namespace kaori::hil
