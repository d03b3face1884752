// A GPIO chip by the few calls that we need: an interface over libgpiod 1.6, whose API version 2 replaces,
// and one that tests implement.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::gpio {

// How a line is wired on the box. Foot switches and tally lamps close to ground.
struct LineWiring {
  std::uint32_t offset = 0;  // The line's number on its chip.
  bool active_low = true;    // A switch to ground.
  bool pull_up = false;      // Needs a chip with pull-up resistors.
  bool wired = true;         // False: nothing is wired there, and no line is requested.
};

// An edge of one line. The kernel stamps it when the interrupt comes, not when a program reads it.
struct LineEdge {
  Time at{};  // CLOCK_MONOTONIC: the kernel's stamp, or when a polled line was read.
  // After the edge; active-low wiring is already undone.
  bool active = false;
};

// A line that is requested for us until this object ends. No call blocks. Errors of every call:
//   no_such_device  the chip was unplugged
//   io_error        the line could not be read
class InputLine {
 public:
  // Releases the line for others.
  virtual ~InputLine() = default;

  // Readable when ReadEdge may give an edge.
  virtual int pollable() const = 0;

  // Whether the line is active now; active_low is already undone.
  virtual Result<bool> Level() = 0;

  // The oldest edge that was not read. Also: resource_unavailable_try_again (there is none).
  virtual Result<LineEdge> ReadEdge() = 0;
};

// As InputLine, to be driven. Its state after this object's end is up to the chip.
class OutputLine {
 public:
  virtual ~OutputLine() = default;
  // Sets the level; active_low is already undone by the kernel.
  virtual Result<void> Drive(bool active) = 0;
};

// A chip of the kernel, open. One thread. The lines must end before their chip.
class GpioChip {
 public:
  virtual ~GpioChip() = default;

  // Requests a line for this program alone. An input reports both edges; where the chip has no
  // interrupts its level is polled instead (polled_line.h). An output starts inactive. Errors:
  //   invalid_argument         the chip has no such line, or no pull-up resistors
  //   device_or_resource_busy  somebody else has the line
  //   no_such_device           the chip was unplugged
  virtual Result<std::unique_ptr<InputLine>> RequestInput(const LineWiring& wiring) = 0;
  virtual Result<std::unique_ptr<OutputLine>> RequestOutput(const LineWiring& wiring) = 0;
};

// Opens a chip of the kernel by its name ("gpiochip0", "/dev/gpiochip0") or label; a label survives
// another order of chips, as after a USB chip was plugged in. `clock` stamps the edges of chips without
// interrupts, and must outlive the chip. Errors: no_such_device, permission_denied.
Result<std::unique_ptr<GpioChip>> OpenGpioChip(const std::string& name, const Clock& clock);

}  // namespace kaori::gpio
