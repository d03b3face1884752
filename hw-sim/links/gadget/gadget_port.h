// A simulated HID device at this machine's own USB socket: a real box at the other end of a real cable.
#pragma once

#include <optional>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"
#include "hw-sim/devices/hid_device.h"
#include "hw-sim/links/gadget/hid_gadget.h"

namespace kaori::sim {

// One thread; nothing blocks. Unplugged at first, and when this ends.
class GadgetPort {
 public:
  // `controller` is the USB device controller that the cable leads to. Borrows the device.
  GadgetPort(HidGadget gadget, std::string controller, HidDevice& device)
      : gadget_(std::move(gadget)), controller_(std::move(controller)), device_(device) {}
  ~GadgetPort() { Unplug(); }
  GadgetPort(const GadgetPort&) = delete;
  GadgetPort& operator=(const GadgetPort&) = delete;

  // Errors: as HidGadget::Bind, and those of opening its file.
  Result<void> Plug();
  void Unplug();
  bool plugged() const { return file_.valid(); }

  int pollable() const { return file_.get(); }  // Readable when the host sent a report; -1 while unplugged.

  // Reads what the host sent; sends what is due. A host that fetches too slowly gets later reports later.
  void Pump(Time now);
  // When Pump has something to send; nothing while it has none.
  std::optional<Time> next_due(Time now) const;

 private:
  bool Send(const Report& report);  // False: the host has not fetched the one before.

  HidGadget gadget_;
  std::string controller_;
  HidDevice& device_;
  UniqueFd file_;  // /dev/hidgN; invalid while unplugged.
  Report unsent_;  // The host fetches too slowly: it goes first.
};

}  // namespace kaori::sim
