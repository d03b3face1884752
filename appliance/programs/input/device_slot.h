// A device slot: one role that one HID device at a time can fill, and the section of the board that it
// writes. InputService finds devices and moves reports; a slot knows what a report of its kind means and what
// holds while nothing is plugged in.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::input {

// How long buttons and keys that the board shows as held are trusted after a plug without a report that
// confirms them. A device on which something is held reports that at once when it is opened; a device at rest
// reports nothing, so silence for this long means that everything was released meanwhile.
inline constexpr Duration kHeldStateTrust = std::chrono::milliseconds(250);

// A slot is used by one thread and never blocks. It starts from what its section holds, so that a restart of
// the program changes nothing on the board. The calls of one device come in the order Plug, Accept and
// Publish any number of times, Unplug; Tick comes in between and while the slot is empty.
class DeviceSlot {
 public:
  virtual ~DeviceSlot() = default;

  // The name for the log, such as "dial box" or "left stick".
  virtual std::string_view name() const = 0;

  // Starts to decode reports of the device that `identity` describes. `now` is the time of the plug. Errors
  // are those of the decoder's For(); the slot stays empty then. The section is live from this call on,
  // before the first report. `identity` is not kept.
  virtual Result<void> Plug(const ports::HidIdentity& identity, Time now) = 0;

  // Decodes one input report that arrived at `at`; it needs a plugged device. Errors:
  //   bad_message  the report is torn, too short, too long or of an unknown kind; nothing changed.
  // `report` begins with the report's number where the device numbers its reports, as hidraw gives it; it is
  // borrowed for the call. `at` is the time of arrival on CLOCK_MONOTONIC.
  virtual Result<void> Accept(std::span<const std::uint8_t> report, Time at) = 0;

  // Writes the section once for all reports that were accepted since the last call, if there were any.
  // Reports are many and the board wants the newest value only, so that all which wait are decoded first.
  virtual void Publish() = 0;

  // Handles a device that was pulled, or that was not found again after a restart: buttons are released, and
  // values that accumulate (dials, wheel, pushes) stay. The section becomes stale where it was live; one that
  // is absent stays so.
  virtual void Unplug(Time now) = 0;

  // Does what is due by time alone. `device` is the plugged device, or null; it is borrowed for the call.
  // Called at each step of the service, at least every 10 ms.
  virtual void Tick(Time now, ports::HidChannel* device) = 0;
};

}  // namespace kaori::input
