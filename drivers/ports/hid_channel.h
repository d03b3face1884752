// A plugged-in HID device, at its lowest seam: report bytes in, report bytes out.
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

// `port` is where it is plugged in ("1-4.2": the USB port path; a link's name in the simulator). Two equal
// devices share everything else, so roles belong to ports.
struct HidIdentity {
  std::string port;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string name;
  std::vector<std::uint8_t> descriptor;  // The report descriptor, as the device sent it.
};

struct HidInput {
  Time at{};               // When the report arrived.
  std::size_t bytes = 0;   // Length, report id included where the descriptor uses ids.
};

// No call blocks. One thread.
class HidChannel {
 public:
  virtual ~HidChannel() = default;

  // Readable when Read would give a report, or the device is gone.
  virtual int pollable() const = 0;
  virtual const HidIdentity& identity() const = 0;

  // Reads one whole input report into `into` (64 bytes hold every report of ours). Errors:
  //   resource_unavailable_try_again  no report is waiting
  //   no_such_device                  unplugged; every later call says the same
  //   io_error                        the transfer failed; the device may still be there
  virtual Result<HidInput> Read(std::span<std::uint8_t> into) = 0;

  // Sends one output report; byte 0 is the report id, 0 where the descriptor uses none. Errors: as Read,
  //   invalid_argument                empty report
  virtual Result<void> Write(std::span<const std::uint8_t> report) = 0;
};

// The sockets into which HID devices are plugged: a kernel's (hidraw), libusb's, or the simulator's.
class HidBus {
 public:
  virtual ~HidBus() = default;

  // Readable when Ports() may have changed.
  virtual int pollable() const = 0;

  // The ports that hold a device now; takes the pending notices with it. Does not block.
  virtual Result<std::vector<std::string>> Ports() = 0;

  // Errors: no_such_device (pulled meanwhile), permission_denied, device_or_resource_busy.
  virtual Result<std::unique_ptr<HidChannel>> Open(const std::string& port) = 0;
};

}  // namespace kaori::ports
