// The few things that we ask of a GPIO chip: the seam between our lines and libgpiod 1.6, whose API 2
// replaces.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::gpio {

struct LineWiring {
  std::uint32_t offset = 0;  // Of the line on its chip.
  bool active_low = true;    // A switch to ground.
  bool pull_up = false;      // Needs a chip that has pull-ups.
  bool wired = true;         // False: nothing is there, and none is taken.
};

struct LineEdge {
  Time at{};  // The kernel's stamp.
  bool active = false;
};

// A line that is ours until this ends. No call blocks. Errors: no_such_device, io_error.
class InputLine {
 public:
  virtual ~InputLine() = default;
  virtual int pollable() const = 0;  // Readable when ReadEdge would give an edge.
  virtual Result<bool> Level() = 0;
  virtual Result<LineEdge> ReadEdge() = 0;  // Beside: resource_unavailable_try_again.
};

class OutputLine {
 public:
  virtual ~OutputLine() = default;
  virtual Result<void> Drive(bool active) = 0;
};

class GpioChip {
 public:
  virtual ~GpioChip() = default;
  // Errors: invalid_argument (no such line, or no pull-up), device_or_resource_busy, no_such_device.
  virtual Result<std::unique_ptr<InputLine>> RequestInput(const LineWiring& wiring) = 0;
  virtual Result<std::unique_ptr<OutputLine>> RequestOutput(const LineWiring& wiring) = 0;  // Starts inactive.
};

// By name ("gpiochip0", "/dev/gpiochip0") or label. Lines must end before their chip. Errors: no_such_device,
// permission_denied.
Result<std::unique_ptr<GpioChip>> OpenGpioChip(const std::string& name);

}  // namespace kaori::gpio
