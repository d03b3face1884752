#include "drivers/gpio/polled_line.h"

#include <unistd.h>

#include <utility>

#include "drivers/base/timer.h"
#include "drivers/base/unique_fd.h"

namespace kaori::gpio {
namespace {

constexpr Duration kPeriod = std::chrono::milliseconds(40);  // As Linux polls a CP2112.

// A level that is asked for from outside counts as seen, so that one change never gives two edges.
class PolledInput final : public InputLine {
 public:
  PolledInput(std::unique_ptr<InputLine> plain, UniqueFd timer, const Clock& clock)
      : plain_(std::move(plain)), timer_(std::move(timer)), clock_(clock) {}

  int pollable() const override { return timer_.get(); }

  Result<bool> Level() override {
    auto level = plain_->Level();
    // What the caller has seen is no edge any more.
    if (level) active_ = *level;
    return level;
  }

  Result<LineEdge> ReadEdge() override {
    const auto nothing = [] {
      return Fail(std::errc::resource_unavailable_try_again, "read an edge of a polled GPIO line");
    };
    // Before its turn the line is not read at all: reading a chip behind USB takes milliseconds.
    // A read of the timer takes its expirations, and fails with EAGAIN until the next. Several
    // that have passed are one look at the line.
    std::uint64_t ticks = 0;
    if (::read(timer_.get(), &ticks, sizeof ticks) < 0) return nothing();
    const auto level = plain_->Level();
    if (!level) return tl::unexpected(level.error());
    if (std::exchange(active_, *level) == *level) return nothing();
    // The time at which the change was found: the change itself lies up to a period earlier.
    return LineEdge{.at = clock_.now(), .active = *level};
  }

 private:
  std::unique_ptr<InputLine> plain_;
  UniqueFd timer_;
  const Clock& clock_;
  bool active_ = false;  // When it was read last.
};

}  // namespace

Result<std::unique_ptr<InputLine>> PollLine(std::unique_ptr<InputLine> plain, Duration first,
                                            const Clock& clock) {
  auto timer = OpenTimer(first, kPeriod, "make a timer to poll a GPIO line");
  if (!timer) return tl::unexpected(timer.error());
  return std::make_unique<PolledInput>(std::move(plain), std::move(*timer), clock);
}

}  // namespace kaori::gpio
