// The GPIO lines of one chip as ports::GpioLines: edges of all inputs in the order of time, outputs by index.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/unique_fd.h"
#include "drivers/gpio/gpio_chip.h"
#include "drivers/ports/gpio_lines.h"

namespace kaori::gpio {

// Which lines of a chip are used, and how: from the show's profile, in the order of their roles.
struct Wiring {
  std::vector<LineWiring> inputs{};  // 32 at most; the index is the line's number in the port.
  // The index is the line's number in Drive.
  std::vector<LineWiring> outputs{};
};

// As ports::GpioLines. An edge is given once no other line can have an older one: each
// line has a descriptor and a queue of its own in the kernel, and only one edge of
// each, read ahead, tells which is the oldest. One thread.
class ChipLines final : public ports::GpioLines {
 public:
  // Requests every line of `wiring`, or none of them. Owns the chip, also where it fails. Errors:
  // invalid_argument (more than 32 inputs), and those of GpioChip.
  static Result<std::unique_ptr<ChipLines>> Request(std::unique_ptr<GpioChip> chip, const Wiring& wiring);

  int pollable() const override { return epoll_.get(); }
  Result<std::uint32_t> Levels() override;
  Result<ports::GpioEdge> ReadEdge() override;
  Result<void> Drive(std::uint32_t line, bool active) override;

 private:
  // One input with the edge that was read ahead of it.
  struct Input {
    std::unique_ptr<InputLine> line;  // Null where none is wired: it is never active.
    std::optional<LineEdge> next;     // Read from the kernel, and not yet given.
  };
  ChipLines(std::unique_ptr<GpioChip> chip, UniqueFd epoll, UniqueFd wake);
  // Requests an input and watches its descriptor. Errors: those of GpioChip.
  Result<void> AddInput(const LineWiring& wiring);
  // Reads each line's next edge where none is kept. Errors: those of InputLine.
  Result<void> ReadAhead();
  // Makes `wake_` readable exactly while an edge was read ahead.
  void UpdateWake();

  std::unique_ptr<GpioChip> chip_;  // Declared before the lines: it must outlive them.
  std::vector<Input> inputs_;
  std::vector<std::unique_ptr<OutputLine>> outputs_;
  // Watches the inputs' descriptors and `wake_`; it is what pollable() gives.
  UniqueFd epoll_;
  UniqueFd wake_;  // Readable while an input has a `next`, which the kernel knows no more.
};

// Opens the chip and requests its lines, which are read on a thread of their own (background_lines.h). Blocks for a chip behind
// USB, which answers within some milliseconds. `clock` must outlive them. Errors: those of OpenGpioChip, of
// ChipLines::Request and of BackgroundLines::Begin.
Result<std::unique_ptr<ports::GpioLines>> OpenLines(const std::string& chip, const Wiring& wiring,
                                                    const Clock& clock);

}  // namespace kaori::gpio
