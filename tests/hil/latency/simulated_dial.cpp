#include "tests/hil/latency/simulated_dial.h"

#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "firmware/wire/dial_box.h"

namespace kaori::latency {
namespace {

Result<void> Send(int kernel, const uhid_event& event) {
  if (::write(kernel, &event, sizeof(event)) != sizeof(event)) return FailErrno("write to /dev/uhid");
  return {};
}

}  // namespace

Result<SimulatedDial> SimulatedDial::Open() {
  UniqueFd kernel(::open("/dev/uhid", O_RDWR | O_CLOEXEC | O_NONBLOCK));
  if (!kernel.valid()) return FailErrno("open /dev/uhid");
  uhid_event event{};
  event.type = UHID_CREATE2;
  auto& box = event.u.create2;
  constexpr std::string_view kName = "Kaori dial box on a bench";
  std::ranges::copy(kName, box.name);
  std::ranges::copy(wire::kDialBoxDescriptor, box.rd_data);
  box.rd_size = wire::kDialBoxDescriptor.size();
  box.bus = BUS_USB;
  box.vendor = wire::kDialBoxVendor;
  box.product = wire::kDialBoxProduct;
  if (auto made = Send(kernel.get(), event); !made) return tl::unexpected(made.error());
  return SimulatedDial(std::move(kernel));
}

Result<Time> SimulatedDial::Turn(const Clock& clock) {
  wire::DialBoxReport report;
  report.turned[0] = 1;
  const auto bytes = wire::Encode(report);
  uhid_event event{};
  event.type = UHID_INPUT2;
  event.u.input2.size = static_cast<std::uint16_t>(bytes.size());
  std::ranges::copy(bytes, event.u.input2.data);
  const Time at = clock.now();
  if (auto sent = Send(kernel_.get(), event); !sent) return tl::unexpected(sent.error());
  return at;
}

// It has nothing to tell but its reports; a question without an answer would hold its reader up for seconds.
void SimulatedDial::Answer() {
  uhid_event asked{};
  while (::read(kernel_.get(), &asked, sizeof(asked)) > 0) {
    uhid_event answer{};
    if (asked.type == UHID_GET_REPORT) {
      answer.type = UHID_GET_REPORT_REPLY;
      answer.u.get_report_reply.id = asked.u.get_report.id;
      answer.u.get_report_reply.err = EIO;
    } else if (asked.type == UHID_SET_REPORT) {
      answer.type = UHID_SET_REPORT_REPLY;
      answer.u.set_report_reply.id = asked.u.set_report.id;
    } else {
      continue;
    }
    [[maybe_unused]] const auto told = Send(kernel_.get(), answer);
  }
}

}  // namespace kaori::latency
