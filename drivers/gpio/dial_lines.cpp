#include "drivers/gpio/dial_lines.h"

#include <fcntl.h>
#include <linux/gpio.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

#include "drivers/base/number.h"
#include "drivers/base/open_cause.h"
#include "drivers/base/unique_fd.h"

namespace kaori::gpio {
namespace {

// Two lines for each dial, A before B.
constexpr std::size_t kMostDialLines = 2 * decode::kMaxDials;
// More than all dials make in the time for which this program may ever be away; the kernel allows 16 times
// the lines.
constexpr std::uint32_t kEdgesKept = 1024;

// A request for lines of one chip; the chip's own file may be closed meanwhile. Edges carry the kernel's time
// of the interrupt on CLOCK_MONOTONIC, and numbers over all lines of the request, by which a lost one shows.
class KernelDialLines final : public DialLines {
 public:
  KernelDialLines(UniqueFd request, std::vector<std::uint32_t> offsets)
      : request_(std::move(request)), offsets_(std::move(offsets)) {}

  int pollable() const override { return request_.get(); }

  Result<decode::DialEdge> ReadEdge() override {
    gpio_v2_line_event event{};
    const ssize_t got = ::read(request_.get(), &event, sizeof event);
    if (got < 0) return FailErrno("read an edge of a dial");
    if (got != static_cast<ssize_t>(sizeof event))
      return Fail(std::errc::no_such_device, "read an edge of a dial");
    const auto line = std::ranges::find(offsets_, event.offset) - offsets_.begin();
    return decode::DialEdge{.at = Time{} + Duration(event.timestamp_ns),
                            .line = static_cast<std::uint32_t>(line),
                            .active = event.id == GPIO_V2_LINE_EVENT_RISING_EDGE,
                            .sequence = event.seqno};
  }

  Result<std::uint32_t> Levels() override {
    gpio_v2_line_values values{.bits = 0, .mask = (std::uint64_t{1} << offsets_.size()) - 1};
    if (::ioctl(request_.get(), GPIO_V2_LINE_GET_VALUES_IOCTL, &values) != 0)
      return FailErrno("read the levels of the dials");
    return static_cast<std::uint32_t>(values.bits);
  }

 private:
  UniqueFd request_;
  std::vector<std::uint32_t> offsets_;
};

// -1 where the kernel refuses, which errno says why.
int Request(int chip, const std::vector<std::uint32_t>& offsets, std::uint64_t bias) {
  gpio_v2_line_request request{};
  std::ranges::copy(offsets, std::begin(request.offsets));
  std::ranges::copy(std::string_view("kaori-input"), std::begin(request.consumer));
  request.config.flags =
      GPIO_V2_LINE_FLAG_INPUT | GPIO_V2_LINE_FLAG_EDGE_RISING | GPIO_V2_LINE_FLAG_EDGE_FALLING | bias;
  request.num_lines = static_cast<std::uint32_t>(offsets.size());
  request.event_buffer_size = kEdgesKept;
  return ::ioctl(chip, GPIO_V2_GET_LINE_IOCTL, &request) == 0 ? request.fd : -1;
}

}  // namespace

// The second try without pull-ups is made for each kind of failure: where lines are busy or missing it fails
// in the same way, and its cause is the one that is told.
Result<std::unique_ptr<DialLines>> OpenDialLines(const std::string& chip,
                                                 const std::vector<std::uint32_t>& offsets) {
  const std::string path = chip.starts_with('/') ? chip : "/dev/" + chip;
  const UniqueFd fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!fd.valid()) return Fail(CauseOfOpen(errno), "open the GPIO chip " + path);
  UniqueFd request(Request(fd.get(), offsets, GPIO_V2_LINE_FLAG_BIAS_PULL_UP));
  if (!request.valid()) request = UniqueFd(Request(fd.get(), offsets, 0));
  if (!request.valid()) return FailErrno("have the lines of the dials of " + path);
  if (::fcntl(request.get(), F_SETFL, O_NONBLOCK) != 0)
    return FailErrno("have the lines of the dials of " + path);
  return std::make_unique<KernelDialLines>(std::move(request), offsets);
}

// A line that is named twice is refused: its edges would turn two dials, or one of them back and forth.
Result<DialWiring> ParseDialWiring(const std::string& text) {
  const auto refuse = [&] {
    return FailInput("--dials " + text +
                     ": expected a chip and two lines for each dial, such as gpiochip0:4,5,6,7");
  };
  const auto colon = text.find(':');
  if (colon == 0 || colon == std::string::npos) return refuse();
  DialWiring wiring{.chip = text.substr(0, colon), .offsets = {}};
  for (std::string_view rest = std::string_view(text).substr(colon + 1);;) {
    const auto comma = std::min(rest.find(','), rest.size());
    const auto offset = ParseNumber<std::uint32_t>(rest.substr(0, comma));
    if (!offset || std::ranges::find(wiring.offsets, *offset) != wiring.offsets.end()) return refuse();
    wiring.offsets.push_back(*offset);
    if (comma == rest.size()) break;
    rest.remove_prefix(comma + 1);
  }
  if (wiring.offsets.size() % 2 != 0 || wiring.offsets.size() > kMostDialLines) return refuse();
  return wiring;
}

}  // namespace kaori::gpio
