// GPIO lines: foot switches and service switches as inputs, tally lamps as outputs.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::ports {

// An input line that changed. Contacts bounce: whether edges that are close together count as one is for
// the reader to decide, unless the implementation's header says that it debounces.
struct GpioEdge {
  Time at{};               // CLOCK_MONOTONIC: the kernel's stamp, or when a polled line was read.
  std::uint32_t line = 0;  // Index into the input lines, 0..31.
  bool active = false;     // After the edge; active-low wiring is already undone.
};

// Lines of one chip, requested together. They are known by their index in the request, not by the chip's
// offsets. What an output does after their release is up to the chip. No call blocks. One thread.
class GpioLines {
 public:
  // Releases the lines for others.
  virtual ~GpioLines() = default;

  // A descriptor that is readable when ReadEdge may give an edge, or when the chip is gone. It belongs to the lines. It
  // may be readable although there is no edge, as lines that are polled are looked at now and then.
  virtual int pollable() const = 0;

  // All levels at once, as when a program starts or edges were lost. Bit n: input line n is active
  // now, or was after the last edge that ReadEdge gave. Errors:
  //   no_such_device  the chip was unplugged; every later call says the same
  //   io_error        a line could not be read
  virtual Result<std::uint32_t> Levels() = 0;

  // The oldest edge that was not read, of all lines, in the order of their stamps.
  // The kernel keeps a bounded number; where more come, the oldest are lost and
  // Levels tells what counts. Errors: as Levels, and
  //   resource_unavailable_try_again  there is none
  virtual Result<GpioEdge> ReadEdge() = 0;

  // Drives an output line; `line` is an index into the output lines. It stays so until the
  // next call or the end of the lines. Errors: as Levels, and
  //   invalid_argument                there is no such output line
  //   resource_unavailable_try_again  not now; the line is as it was
  virtual Result<void> Drive(std::uint32_t line, bool active) = 0;
};

// Requests the lines; to be called again after a fault. Outputs begin inactive. Errors:
//   no_such_device           the chip is not plugged in
//   permission_denied        the chip may not be opened
//   device_or_resource_busy  somebody else has one of the lines
//   invalid_argument         the chip has no such line
using GpioOpener = std::function<Result<std::unique_ptr<GpioLines>>()>;

}  // namespace kaori::ports
