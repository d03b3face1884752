// The lines of quadrature encoders on a GPIO chip, by uAPI v2 of Linux; and an interface that tests
// implement.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/decode/quadrature.h"

namespace kaori::gpio {

// All lines are requested at once, so that their edges have one order and one numbering. libgpiod 1.6 speaks
// uAPI v1, which keeps 16 edges a line, drops the newest and tells nobody; that is enough for foot switches
// and not for dials. No call blocks. Errors of every call: no_such_device (the chip was unplugged), io_error.
class DialLines {
 public:
  virtual ~DialLines() = default;
  virtual int pollable() const = 0;
  // The oldest edge that was not read. Also: resource_unavailable_try_again (there is none).
  virtual Result<decode::DialEdge> ReadEdge() = 0;
  // Bit n: line n, in the order of the request.
  virtual Result<std::uint32_t> Levels() = 0;
};
using DialLinesOpener = std::function<Result<std::unique_ptr<DialLines>>()>;

// `offsets` are the chip's numbers: A and B of the first dial, A and B of the second; 16 at most. Lines have
// pull-ups, as encoders with open collectors want them; a kernel that has none refuses that, and is asked
// without. Errors:
//   no_such_device, permission_denied, device_or_resource_busy, invalid_argument (no such line)
Result<std::unique_ptr<DialLines>> OpenDialLines(const std::string& chip,
                                                 const std::vector<std::uint32_t>& offsets);

// "gpiochip0:4,5,6,7": the chip, and two lines for each dial.
struct DialWiring {
  std::string chip;
  std::vector<std::uint32_t> offsets;
};
Result<DialWiring> ParseDialWiring(const std::string& text);

}  // namespace kaori::gpio
