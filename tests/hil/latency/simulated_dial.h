// A simulated dial, of a dial box that the kernel's uhid makes.
#pragma once

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::latency {

// One thread.
class SimulatedDial {
 public:
  // Plugs the box in. Errors: those of open(2) on /dev/uhid and of write(2).
  static Result<SimulatedDial> Open();

  // Turns the dial by one count; the moment at which the device reported it. Errors: those of write(2).
  Result<Time> Turn(const Clock& clock);

  // Answers what the kernel asks of the device; to be called often.
  void Answer();

 private:
  explicit SimulatedDial(UniqueFd kernel) : kernel_(std::move(kernel)) {}
  UniqueFd kernel_;
};

}  // namespace kaori::latency
