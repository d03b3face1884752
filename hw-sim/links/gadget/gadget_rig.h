// The simulated input devices, each at a USB device controller of this machine: a real box hangs at the other
// end of real cables.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "hw-sim/devices/input_devices.h"
#include "hw-sim/links/gadget/gadget_port.h"

namespace kaori::sim {

// A rig for tests at a bench, with cables that lead out of this machine. One thread; nothing blocks.
class GadgetRig final : public DeviceRig {
 public:
  // Nothing is plugged in yet. The room says where configfs is mounted; the clock outlives the rig.
  GadgetRig(GadgetRoom room, const Clock& clock);

  // Puts the device of `port` at a controller (a name of /sys/class/udc), the cable in. A second
  // Put of a port replaces the first. Errors: invalid_argument (no HID device is at that port),
  // and those of HidGadget and GadgetPort.
  Result<void> Put(DevicePort port, const std::string& controller);

  // Reads, answers and sends what is due at clock.now(). Call it every few milliseconds:
  // reports are due once a millisecond at most.
  void Pump();

  InputDevices& devices() override { return devices_; }

  // Cables of ports that have no controller are ignored. Errors: as Put.
  Result<void> Do(const OperatorAction& action) override;

 private:
  HidDevice* DeviceAt(DevicePort port);  // Null: no HID device is at that port.

  GadgetRoom room_;
  DeviceContext context_;
  InputDevices devices_;
  // A port is here once it was put at a controller. Ends before the devices that it borrows.
  std::map<DevicePort, std::unique_ptr<GadgetPort>> ports_;
};

}  // namespace kaori::sim
