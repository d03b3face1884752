// The GPIO lines of one chip as a port: edges of all inputs in the order of time, outputs by their index.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/unique_fd.h"
#include "drivers/gpio/gpio_chip.h"
#include "drivers/ports/gpio_lines.h"

namespace kaori::gpio {

struct Wiring {
  std::vector<LineWiring> inputs{};  // 32 at most; the index here is the line's number in the port.
  std::vector<LineWiring> outputs{};
};

// As ports::GpioLines.
class ChipLines final : public ports::GpioLines {
 public:
  // Takes every line of `wiring`, or none. Errors: invalid_argument (more than 32 inputs), and those of the
  // chip.
  static Result<std::unique_ptr<ChipLines>> Request(std::unique_ptr<GpioChip> chip, const Wiring& wiring);

  int pollable() const override { return epoll_.get(); }
  Result<std::uint32_t> Levels() override;
  Result<ports::GpioEdge> ReadEdge() override;
  Result<void> Drive(std::uint32_t line, bool active) override;

 private:
  struct Input {
    std::unique_ptr<InputLine> line;  // None where it is not wired: never active.
    std::optional<LineEdge> next;     // Read from the kernel, but not yet the oldest.
  };
  ChipLines(std::unique_ptr<GpioChip> chip, UniqueFd epoll, UniqueFd kept);
  Result<void> AddInput(const LineWiring& wiring);
  Result<void> Look();
  void ShowWhetherKept();

  std::unique_ptr<GpioChip> chip_;  // Before the lines: it must outlive them.
  std::vector<Input> inputs_;
  std::vector<std::unique_ptr<OutputLine>> outputs_;
  UniqueFd epoll_;
  UniqueFd kept_;  // Readable while an edge waits here and no longer in the kernel.
};

// Opens the chip and takes the lines; see OpenGpioChip and ChipLines::Request.
Result<std::unique_ptr<ports::GpioLines>> OpenLines(const std::string& chip, const Wiring& wiring);

}  // namespace kaori::gpio
