// All simulated devices on USB sockets of a virtual machine, in which the box's own kernel and programs run.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"
#include "hw-sim/devices/gpio_bridge.h"
#include "hw-sim/devices/input_devices.h"
#include "hw-sim/devices/usb_hid.h"
#include "hw-sim/devices/uvc_camera.h"
#include "hw-sim/links/usbredir/usbredir_port.h"

namespace kaori::sim {

// The sockets, in the order of the machine's USB ports: the first is port 1. The machine's command line
// has a channel for each (hw-sim/hil/qemu_command.h).
inline constexpr std::array<std::string_view, 7> kUsbSockets{
    "dial-box", "stick-left", "stick-right", "keyboard", "pointer", "camera", "gpio"};

// "FOLDER/dial-box.usb": where the machine listens, and the rig connects.
std::string UsbSocketPath(const std::string& folder, std::string_view name);

// The devices as USB devices, for a box that runs in a virtual machine: its kernel enumerates them and
// its own drivers read them. One thread; nothing blocks. Everything is unplugged at first.
class UsbRig final : public DeviceRig {
 public:
  // Calls nobody yet: a machine is called once a cable is in. The clock outlives the rig.
  // Errors: those of epoll_create1(2).
  static Result<std::unique_ptr<UsbRig>> Open(const std::string& folder, const Clock& clock);

  // Reads, answers and sends what is due at clock.now(). Call it when pollable() is readable, and at
  // next_due().
  void Pump();
  // Of all connections; readable when a machine has said something.
  int pollable() const { return epoll_.get(); }
  Time next_due() const;  // Time::max() while nothing waits.

  InputDevices& devices() override { return devices_; }
  // Not among DeviceRig's devices: a bridge is no operator's control.
  GpioBridge& gpio() { return gpio_; }
  UvcCamera& camera() { return camera_; }

  // Cables, by the names above. Doing it twice is doing it once. Errors:
  // invalid_argument (no such socket).
  Result<void> Plug(std::string_view name);
  Result<void> Unplug(std::string_view name);
  const UsbredirPort* port(std::string_view name) const;  // Null: no such socket.

  // Another device at the end of a cable, which must be out; null: the rig's own again. The device outlives
  // its turn. Errors: as Plug.
  Result<void> Hold(std::string_view name, UsbDevice* device);

  // Swaps what hangs on the cables of the two sticks, which must be out: a test that roles
  // belong to ports, and not to devices.
  void CrossSticks(bool crossed);

  // Lines are those of the GPIO bridge. Verbs of ports without a USB socket are ignored. Errors: as Plug.
  Result<void> Do(const OperatorAction& action) override;

 private:
  UsbRig(const std::string& folder, const Clock& clock, UniqueFd epoll);

  DeviceContext context_;
  InputDevices devices_;
  // The same devices as a USB host sees them.
  UsbHid dial_box_, left_stick_, right_stick_, keyboard_, pointer_;
  // The camera's stream on USB; devices().camera draws its pictures.
  UvcCamera camera_;
  GpioBridge gpio_;
  std::array<UsbDevice*, kUsbSockets.size()> own_;  // In the order of kUsbSockets.
  // Of all connections.
  UniqueFd epoll_;
  std::array<std::unique_ptr<UsbredirPort>, kUsbSockets.size()> ports_;  // In the order of kUsbSockets.
};

}  // namespace kaori::sim
