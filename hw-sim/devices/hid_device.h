// The appliance's side of a simulated HID device: real report bytes, as they would cross a cable. The verbs of an operator
// are the devices' own.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/clock.h"

namespace kaori::sim {

using Report = std::vector<std::uint8_t>;

// Who the device is, as a host reads it when it is plugged in.
struct HidDeviceName {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string name;
  std::span<const std::uint8_t> descriptor;  // Static memory.
};

// One thread. Reports leave on change only, at most one in a millisecond; what changes in between shares a
// report, but a button that went down and up again gets both its reports.
class HidDevice {
 public:
  virtual ~HidDevice() = default;
  virtual HidDeviceName device_name() const = 0;

  // When the next report may leave; nothing while there is none.
  virtual std::optional<Time> next_due() const = 0;

  // The next report that is due at `now`.
  virtual std::optional<Report> NextReport(Time now) = 0;

  // A report of how things stand, whether due or not; what was turned and not yet reported stays unreported.
  virtual Report Standing() const = 0;

  // An output report, byte 0 the report id. Unknown ones are ignored, as by the real part.
  virtual void HandleOutput(std::span<const std::uint8_t> report) = 0;

  // A host began to listen: it gets one report if anything is not at rest. While none listens, changes gather
  // in one report.
  virtual void HostCame() = 0;
  virtual void HostLeft() = 0;

  // The power went or came: what was not reported is lost, lamps are dark; controls stay where they are.
  virtual void PowerCycle() = 0;
};

}  // namespace kaori::sim
