#include "drivers/gpio/gpio_chip.h"

#include <gpiod.h>

#include <cerrno>
#include <string_view>

#include "drivers/gpio/polled_line.h"

namespace kaori::gpio {
namespace {

// The name under which tools such as gpioinfo list our lines.
constexpr const char* kConsumer = "kaori";

struct CloseChip {
  void operator()(gpiod_chip* chip) const { gpiod_chip_close(chip); }
};
struct ReleaseLine {
  void operator()(gpiod_line* line) const { gpiod_line_release(line); }
};
using Line = std::unique_ptr<gpiod_line, ReleaseLine>;

// What was tried, and on which line, for errors.
std::string Named(const char* verb, gpiod_line* line) {
  return verb + std::string(" GPIO line ") + std::to_string(gpiod_line_offset(line));
}

// libgpiod leaves the cause in errno.
tl::unexpected<Error> Failed(const char* verb, gpiod_line* line) {
  const bool gone = errno == ENODEV || errno == ENXIO;
  return Fail(gone ? std::errc::no_such_device : std::errc::io_error, Named(verb, line));
}

// What the kernel says of a chip without interrupts (gpiod_to_irq fails with ENXIO or ENODEV); and of
// one that was unplugged, which says it again when the line is requested without edges.
bool HasNoEdges(const Error& error) {
  return error.cause == std::errc::no_such_device || error.cause == std::errc::no_such_device_or_address;
}

class Input final : public InputLine {
 public:
  explicit Input(Line line) : line_(std::move(line)) {}
  int pollable() const override { return gpiod_line_event_get_fd(line_.get()); }

  Result<bool> Level() override {
    const int level = gpiod_line_get_value(line_.get());
    if (level < 0) return Failed("read", line_.get());
    return level != 0;
  }

  Result<LineEdge> ReadEdge() override {
    // libgpiod's reading blocks, so it is asked first whether there is an edge.
    const timespec at_once{};
    const int waiting = gpiod_line_event_wait(line_.get(), &at_once);
    if (waiting == 0) return Fail(std::errc::resource_unavailable_try_again, Named("read", line_.get()));
    gpiod_line_event event{};
    if (waiting < 0 || gpiod_line_event_read(line_.get(), &event) < 0) return Failed("read", line_.get());
    // Linux stamps line events with CLOCK_MONOTONIC since 5.7. Earlier
    // kernels used CLOCK_REALTIME, which jumps.
    return LineEdge{.at = Time{} + std::chrono::seconds(event.ts.tv_sec) + Duration(event.ts.tv_nsec),
                    .active = event.event_type == GPIOD_LINE_EVENT_RISING_EDGE};
  }

 private:
  Line line_;
};

// A line that is driven; released with the object, and what the chip does with it then is its driver's
// choice.
class Output final : public OutputLine {
 public:
  explicit Output(Line line) : line_(std::move(line)) {}
  Result<void> Drive(bool active) override {
    if (gpiod_line_set_value(line_.get(), active ? 1 : 0) < 0) return Failed("drive", line_.get());
    return {};
  }

 private:
  Line line_;
};

class Chip final : public GpioChip {
 public:
  Chip(std::unique_ptr<gpiod_chip, CloseChip> chip, const Clock& clock)
      : chip_(std::move(chip)), clock_(clock) {}

  Result<std::unique_ptr<InputLine>> RequestInput(const LineWiring& wiring) override {
    if (!IsPolledByItsDriver()) {
      auto line = Request(wiring, GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES);
      if (line) return std::make_unique<Input>(std::move(*line));
      if (!HasNoEdges(line.error())) return tl::unexpected(line.error());
    }
    auto plain = Request(wiring, GPIOD_LINE_REQUEST_DIRECTION_INPUT);
    if (!plain) return tl::unexpected(plain.error());
    // An MCP2221 has four lines, a CP2112 eight, and each read of one takes some milliseconds of
    // USB: each line has its own turn of 10 ms within the period of 40 ms
    // (polled_line.h), so that no turn of the loop waits for two.
    constexpr std::uint32_t kTurns = 4;
    constexpr Duration kTurn = std::chrono::milliseconds(10);
    return PollLine(std::make_unique<Input>(std::move(*plain)), kTurn * (1 + wiring.offset % kTurns), clock_);
  }

  Result<std::unique_ptr<OutputLine>> RequestOutput(const LineWiring& wiring) override {
    auto line = Request(wiring, GPIOD_LINE_REQUEST_DIRECTION_OUTPUT);
    if (!line) return tl::unexpected(line.error());
    return std::make_unique<Output>(std::move(*line));
  }

 private:
  // A CP2112 has no interrupts either: Linux looks at it every 40 ms and makes edges of what it finds. Where
  // the last line with edges is released it waits for that look while it holds a spin lock ("BUG: scheduling
  // while atomic" in cp2112_gpio_irq_shutdown of 6.12), so its lines are asked for without edges.
  bool IsPolledByItsDriver() const {
    return gpiod_chip_label(chip_.get()) == std::string_view("cp2112_gpio");
  }

  Result<Line> Request(const LineWiring& wiring, int request_type) {
    const std::string attempt = "request GPIO line " + std::to_string(wiring.offset);
    gpiod_line* line = gpiod_chip_get_line(chip_.get(), wiring.offset);
    if (line == nullptr) return FailErrno(attempt);
    // Lines keep their wiring's polarity in the kernel: values are logical from here on. A chip that has
    // no pull-up resistors refuses the flag with EINVAL or ENOTSUPP.
    const int flags = (wiring.active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0) |
                      (wiring.pull_up ? GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP : 0);
    const gpiod_line_request_config config{
        .consumer = kConsumer, .request_type = request_type, .flags = flags};
    constexpr int kInactive = 0;
    if (gpiod_line_request(line, &config, kInactive) < 0) return FailErrno(attempt);
    return Line(line);
  }

  std::unique_ptr<gpiod_chip, CloseChip> chip_;
  const Clock& clock_;
};

}  // namespace

Result<std::unique_ptr<GpioChip>> OpenGpioChip(const std::string& name, const Clock& clock) {
  std::unique_ptr<gpiod_chip, CloseChip> chip(gpiod_chip_open_lookup(name.c_str()));
  if (chip) return std::make_unique<Chip>(std::move(chip), clock);
  // Every other cause means that there is no such chip now.
  const bool denied = errno == EACCES || errno == EPERM;
  return Fail(denied ? std::errc::permission_denied : std::errc::no_such_device, "open GPIO chip " + name);
}

}  // namespace kaori::gpio
