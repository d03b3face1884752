// The appliance's side of a simulated HID device: real report bytes, as they would cross a cable. The verbs
// of an operator are the devices' own.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/clock.h"

namespace kaori::sim {

// The bytes of a report without the report id, as none of our devices has any.
using Report = std::vector<std::uint8_t>;

// Who the device is, as a host reads it when it is plugged in.
struct HidDeviceName {
  // USB ids, under which drivers find it.
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string name;
  std::span<const std::uint8_t> descriptor;  // Static memory.
  // Of the interrupt endpoints, at most: all reports of ours fit into one packet.
  std::uint16_t packet_bytes = 64;
};

// A device's own side of the cable: what a microcontroller would do. One thread. Reports leave on change
// only, at most one in a millisecond; what changes in between shares a report, but a button that went
// down and up again gets both its reports. Time comes from outside: nothing happens between two calls.
class HidDevice {
 public:
  // Does not change.
  virtual ~HidDevice() = default;
  // Lives as long as the device.
  virtual HidDeviceName device_name() const = 0;

  // When the next report may leave; nothing while there is none.
  virtual std::optional<Time> next_due() const = 0;

  // The next report that is due at `now`; nothing: none is. Called again until there is none.
  virtual std::optional<Report> NextReport(Time now) = 0;

  // A report of how things stand, whether due or not, as GET_REPORT asks for it (HID 1.11, 7.2.1); what
  // was turned and not yet reported stays unreported.
  virtual Report Standing() const = 0;

  // An output report, byte 0 the report id, 0 where there is none. Unknown ones
  // are ignored, as by the real part.
  virtual void HandleOutput(std::span<const std::uint8_t> report) = 0;

  // A host began to listen: it gets one report if anything is not at rest. While none listens, changes
  // gather in one report. HostLeft: it stopped, as when the cable is pulled or the program ends.
  virtual void HostCame() = 0;
  virtual void HostLeft() = 0;

  // The power went or came: what was not reported is lost, lamps are dark; controls stay where they are.
  virtual void PowerCycle() = 0;
};

}  // namespace kaori::sim
