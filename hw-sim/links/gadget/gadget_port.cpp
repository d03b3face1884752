#include "hw-sim/links/gadget/gadget_port.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>

#include "hw-sim/devices/report_queue.h"
#include "hw-sim/devices/usb_hid.h"

namespace kaori::sim {
namespace {

// The report_length that HidGadget sets.
constexpr std::size_t kLongestReport = 64;
// A host that never stops sending must not hold the loop.
constexpr int kReportsAtOnce = 64;

}  // namespace

Result<void> GadgetPort::Plug() {
  if (plugged()) return {};
  // The power comes with the cable.
  device_.PowerCycle();
  if (auto ok = gadget_.Bind(controller_); !ok) return ok;
  if (auto ok = OpenFile(); !ok) {
    // Nobody would answer the box, and Unplug does nothing without the file.
    gadget_.Unbind();
    return ok;
  }
  // f_hid tells of no host that listens: reports go from here on, and wait until one fetches them.
  device_.HostCame();
  return {};
}

// The kernel's hidg file of the function, which is there once the gadget is bound.
Result<void> GadgetPort::OpenFile() {
  const auto path = gadget_.DeviceFile();
  if (!path) return tl::unexpected(path.error());
  file_ = UniqueFd(::open(path->c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
  if (!file_.valid()) return FailErrno("open " + *path);
  return {};
}

void GadgetPort::Unplug() {
  if (!plugged()) return;
  // The file must be closed first: while it is open the kernel keeps the function, and unbinding waits.
  file_.reset();
  gadget_.Unbind();
  unsent_.clear();
  device_.HostLeft();
  device_.PowerCycle();
}

// Above the cable a report without a number begins with a 0.
void GadgetPort::Pump(Time now) {
  if (!plugged()) return;
  const std::size_t before = ShapeOf(device_.device_name().descriptor).numbers_reports ? 0 : 1;
  std::array<std::uint8_t, kLongestReport + 1> buffer{};
  for (int n = 0; n < kReportsAtOnce; ++n) {
    const ssize_t got = ::read(file_.get(), buffer.data() + before, kLongestReport);
    // 0: the host sent nothing. EAGAIN ends the loop as well.
    if (got <= 0) break;
    device_.HandleOutput(std::span(buffer).first(before + static_cast<std::size_t>(got)));
  }
  if (!unsent_.empty() && !Send(unsent_)) return;
  unsent_.clear();
  while (auto report = device_.NextReport(now)) {
    if (Send(*report)) continue;
    unsent_ = std::move(*report);
    return;
  }
}

std::optional<Time> GadgetPort::next_due(Time now) const {
  if (!plugged()) return std::nullopt;
  return unsent_.empty() ? device_.next_due() : now + kReportPeriod;
}

bool GadgetPort::Send(const Report& report) {
  return ::write(file_.get(), report.data(), report.size()) == static_cast<ssize_t>(report.size());
}

}  // namespace kaori::sim
