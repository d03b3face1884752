// A HID device by its reports' bytes, and the bus that it is plugged into.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::ports {

// What is known of a device before its first report. Two equal devices differ in `port` alone, so roles belong to
// ports: what is plugged into the left socket is the left stick, whichever of two equal sticks it is. A value: it
// outlives the device and its channel.
struct HidIdentity {
  std::string port;  // Where it is plugged in: the USB port path "1-4.2", or a link's name in the simulator.
  std::uint16_t vendor = 0;   // USB vendor id.
  std::uint16_t product = 0;  // USB product id.
  std::string name;           // As the device tells it, for people; may be empty.
  // The report descriptor, as the device sent it. It is trusted as little as the name: its decoder bears any bytes.
  std::vector<std::uint8_t> descriptor;
};

// An input report that was read.
struct HidInput {
  Time at{};              // When the report arrived, as near as the implementation knows.
  std::size_t bytes = 0;  // Its length, the report id included where the descriptor has ids.
};

// One device, opened. Its reports are the device's own bytes; drivers/decode gives them a meaning. The
// device is released with the channel, which ends before its bus. No call blocks. One thread.
class HidChannel {
 public:
  // Closes the device: another program may open it.
  virtual ~HidChannel() = default;

  // A descriptor that is readable when Read would give a report,
  // or when the device is gone. It belongs to the channel.
  virtual int pollable() const = 0;

  // Does not change, and lives as long as the channel.
  virtual const HidIdentity& identity() const = 0;

  // Reads the oldest input report into `into`, report id first where the descriptor has ids. What does not
  // fit is cut off; 64 bytes hold every report of ours. Errors:
  //   resource_unavailable_try_again  there is no report
  //   no_such_device                  the device was unplugged; every later call says the same. Reports that
  //                                   arrived before are given first
  //   io_error                        a transfer failed; the device may still be there
  virtual Result<HidInput> Read(std::span<std::uint8_t> into) = 0;

  // Sends one output report. Byte 0 is the report id, 0 where the descriptor has none. `report` is not
  // used after the call. Success means that the report is on its way, not that the device showed it: what
  // was wrong with it a later call may tell. Errors: as Read, and
  //   resource_unavailable_try_again  too many reports are under way
  //   invalid_argument                `report` is empty
  virtual Result<void> Write(std::span<const std::uint8_t> report) = 0;

  // The feature report whose id is byte 0 of `into` (0 where the descriptor has none), asked for now: the
  // rest of `into` is filled, and the answer's length, id included, is given. May block as long as the kernel
  // waits for a device. Errors:
  //   not_supported   this channel has no such way
  //   no_such_device, io_error   as Read; io_error too where the device refuses (STALL)
  virtual Result<std::size_t> GetFeature(std::span<std::uint8_t> into) {
    static_cast<void>(into);
    return Fail(std::errc::not_supported, "read a feature of " + identity().port);
  }
  // Sends a feature report, byte 0 the id as above. Blocks and fails as GetFeature.
  virtual Result<void> SetFeature(std::span<const std::uint8_t> report) {
    static_cast<void>(report);
    return Fail(std::errc::not_supported, "send a feature to " + identity().port);
  }
};

// Where HID devices are plugged in: the kernel's hidraw, libusb, or the simulator's folder. A program
// opens one bus and looks at its ports again whenever it becomes readable; there are no callbacks. No
// call blocks but Open, as the implementations' headers say. One thread. Must outlive its channels.
class HidBus {
 public:
  virtual ~HidBus() = default;

  // A descriptor that is readable when Ports() may have changed. It belongs to the bus.
  virtual int pollable() const = 0;

  // The ports that have a device now, sorted by name. Reads the pending notices, so that pollable() is
  // readable no more. Errors: those of the system calls.
  virtual Result<std::vector<std::string>> Ports() = 0;

  // Opens the device at a port of Ports(); the caller owns the channel. Every device may be opened: whether it is one
  // of ours is decided by its descriptor. Errors:
  //   no_such_device           nothing is plugged in there
  //   permission_denied        the device may not be opened
  //   device_or_resource_busy  another program uses it, or it has not answered yet; try again
  //   io_error                 it does not send its descriptors
  //   not_supported            nobody has said what the device does; that stays so while it is plugged in
  virtual Result<std::unique_ptr<HidChannel>> Open(const std::string& port) = 0;
};

}  // namespace kaori::ports
