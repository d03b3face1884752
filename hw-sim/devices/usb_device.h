// The appliance's side of a simulated USB device: who it is, and what it answers on its endpoints.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/clock.h"

namespace kaori::sim {

// Bytes as they cross the cable.
using UsbBytes = std::vector<std::uint8_t>;

// The numbers are those that usbredir uses.
enum class UsbSpeed : std::uint8_t { kLow, kFull, kHigh };

// The eight bytes that begin a control transfer (USB 2.0, 9.3).
struct UsbSetup {
  std::uint8_t type = 0;     // bmRequestType. Bit 7: the device answers with data.
  std::uint8_t request = 0;  // bRequest.
  std::uint16_t value = 0;   // wValue.
  std::uint16_t index = 0;   // wIndex: an interface or an endpoint where the request is for one.
  std::uint16_t length = 0;  // wLength: bytes that follow, or at most so many that come back.
};

// What a host reads first (USB 2.0, 9.6). One configuration, as every device of ours has. Numbers are in
// the machine's order here; the descriptors are little-endian.
struct UsbDescriptors {
  // Devices of ours run at high speed: a real host polls them in microframes then.
  UsbSpeed speed = UsbSpeed::kHigh;
  std::uint8_t device_class = 0;  // 0: said by each interface.
  // bDeviceSubClass and bDeviceProtocol.
  std::uint8_t device_subclass = 0;
  std::uint8_t device_protocol = 0;
  // idVendor and idProduct.
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  // bcdDevice: 0x0100 is release 1.00.
  std::uint16_t release_bcd = 0x0100;
  // ASCII, for the string descriptors.
  std::string maker;
  std::string name;
  UsbBytes configuration;  // The whole of it: interfaces, endpoints, class descriptors.
};

// A simulated part at the end of a USB cable. A link asks for transfers, as a host controller does, and
// answers by itself what every device answers alike (see usb_descriptors.h). One thread; no call blocks.
class UsbDevice {
 public:
  // The cable must be out.
  virtual ~UsbDevice() = default;

  // Does not change.
  virtual const UsbDescriptors& descriptors() const = 0;

  // A control request that is not of every device, with the data that came along. Gives
  // the data that goes back, empty for one without; or nothing: the request stalls. The
  // link cuts what is longer than wLength.
  virtual std::optional<UsbBytes> Answer(const UsbSetup& setup, std::span<const std::uint8_t> data) = 0;

  // Whether it answers the requests of every device by itself: what it leaves alone stalls then.
  virtual bool answers_standard() const { return false; }

  // Data for an OUT endpoint, one transfer. What the device cannot use it drops.
  virtual void HandleOut(std::uint8_t endpoint, std::span<const std::uint8_t> data) = 0;

  // The next transfer of an IN endpoint that is due at `now`, at most `room_bytes` long;
  // nothing: none yet, and the host is answered with NAK. A transfer that is shorter than
  // asked for ends what the host reads.
  virtual std::optional<UsbBytes> NextIn(std::uint8_t endpoint, std::size_t room_bytes, Time now) = 0;

  // When NextIn next has something, `now` where it has it already; nothing while it has none.
  // Asked only while a host waits for it.
  virtual std::optional<Time> next_due(Time now) const = 0;

  // A host began to poll an interrupt endpoint, or ended. Bulk endpoints have no such moment.
  virtual void HostCame(std::uint8_t endpoint) = 0;
  virtual void HostLeft(std::uint8_t endpoint) = 0;

  // Power went or came: what was not sent is lost, and the device is as it was when
  // it was new, but for its controls.
  virtual void PowerCycle() = 0;
};

}  // namespace kaori::sim
