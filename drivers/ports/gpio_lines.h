// A handful of GPIO lines: foot switches and service switches in, tally lamps out.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::ports {

struct GpioEdge {
  Time at{};               // The kernel's stamp.
  std::uint32_t line = 0;  // Index into the lines that were asked for, 0..31.
  bool active = false;     // After the edge; active-low wiring is already undone.
};

// No call blocks. One thread.
class GpioLines {
 public:
  virtual ~GpioLines() = default;

  // Readable when ReadEdge would give an edge.
  virtual int pollable() const = 0;

  // Bit n: input line n is active now. Errors: no_such_device, io_error.
  virtual Result<std::uint32_t> Levels() = 0;

  // The oldest edge not yet read. Errors: resource_unavailable_try_again, no_such_device, io_error.
  virtual Result<GpioEdge> ReadEdge() = 0;

  // Drives output line `line` (index into the output lines). Errors: no_such_device, invalid_argument.
  virtual Result<void> Drive(std::uint32_t line, bool active) = 0;
};

// Takes the lines anew after any fault. Errors: no_such_device, permission_denied, device_or_resource_busy,
// invalid_argument (the chip has no such line).
using GpioOpener = std::function<Result<std::unique_ptr<GpioLines>>()>;

}  // namespace kaori::ports
