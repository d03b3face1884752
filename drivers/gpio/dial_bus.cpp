#include "drivers/gpio/dial_bus.h"

#include <sys/eventfd.h>

#include "drivers/decode/dial_box_reporter.h"
#include "firmware/wire/dial_box.h"

namespace kaori::gpio {
namespace {

constexpr const char* kPort = "gpio-dials";
// Edges that go into one report at most, so that one that floods does not hold up others.
constexpr int kEdgesAtOnce = 256;

class DialChannel final : public ports::HidChannel {
 public:
  DialChannel(std::unique_ptr<DialLines> lines, std::uint32_t levels, const Clock& clock)
      : lines_(std::move(lines)), dials_(levels), clock_(clock) {}

  int pollable() const override { return lines_->pollable(); }
  const ports::HidIdentity& identity() const override { return identity_; }

  Result<ports::HidInput> Read(std::span<std::uint8_t> into) override {
    bool turned = reporter_.has_rest();
    for (int n = 0; n < kEdgesAtOnce; ++n) {
      const auto edge = lines_->ReadEdge();
      if (!edge && turned) break;
      if (!edge) return dials_.Expire(clock_.now()) ? Lost() : tl::unexpected(edge.error());
      turned |= dials_.Accept(*edge);
      at_ = edge->at;
      if (dials_.needs_levels()) return Lost();
    }
    // Edges without a turn are no report; the loop comes again for the rest.
    if (!turned) return Fail(std::errc::resource_unavailable_try_again, std::string("read ") + kPort);
    return ports::HidInput{.at = at_, .bytes = reporter_.Report(dials_.counts(), 0, into)};
  }

  // There are no lamps.
  Result<void> Write(std::span<const std::uint8_t>) override { return {}; }

 private:
  // The error of a gap is told after the dials go on. The time is that before the levels: an edge in between
  // is in them already, and comes to no turn when it is read; passed over it would be missing.
  Result<ports::HidInput> Lost() {
    const Time at = clock_.now();
    const auto levels = lines_->Levels();
    if (!levels) return tl::unexpected(levels.error());
    dials_.Resume(*levels, at);
    return Fail(std::errc::bad_message,
                "the kernel dropped edges of the dials on GPIO lines; they moved nothing");
  }

  std::unique_ptr<DialLines> lines_;
  decode::QuadratureDials dials_;
  const Clock& clock_;
  decode::DialBoxReporter reporter_;
  Time at_{};
  const ports::HidIdentity identity_{
      .port = kPort,
      .vendor = 0,
      .product = 0,
      .name = "dials on GPIO lines",
      .descriptor = {wire::kDialBoxDescriptor.begin(), wire::kDialBoxDescriptor.end()}};
};

}  // namespace

Result<std::unique_ptr<DialBus>> DialBus::Open(DialLinesOpener open, const Clock& clock) {
  UniqueFd nothing(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC));
  if (!nothing.valid()) return FailErrno("make the bus of the dials");
  return std::unique_ptr<DialBus>(new DialBus(std::move(open), clock, std::move(nothing)));
}

Result<std::vector<std::string>> DialBus::Ports() {
  return std::vector<std::string>{kPort};
}

// The levels of the beginning are read after the request, so that an edge in between is seen as one that came
// before.
Result<std::unique_ptr<ports::HidChannel>> DialBus::Open(const std::string& port) {
  if (port != kPort) return Fail(std::errc::no_such_device, "open " + port);
  auto lines = open_();
  if (!lines) return tl::unexpected(lines.error());
  const auto levels = (*lines)->Levels();
  if (!levels) return tl::unexpected(levels.error());
  return std::make_unique<DialChannel>(std::move(*lines), *levels, clock_);
}

}  // namespace kaori::gpio
