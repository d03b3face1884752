// A simulated HID device at this machine's own USB socket: a real box at the other end of a real cable.
#pragma once

#include <optional>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"
#include "hw-sim/devices/hid_device.h"
#include "hw-sim/links/gadget/hid_gadget.h"

namespace kaori::sim {

// Carries a device's reports to a box that cannot tell it from the real part: the USB stack, the cable
// and the box's kernel are all real. One thread; nothing blocks. Unplugged at first, and when this ends.
class GadgetPort {
 public:
  // `controller` is the USB device controller that the cable leads to, by its name in /sys/class/udc.
  // Borrows the device, which must outlive the port.
  GadgetPort(HidGadget gadget, std::string controller, HidDevice& device)
      : gadget_(std::move(gadget)), controller_(std::move(controller)), device_(device) {}
  ~GadgetPort() { Unplug(); }
  GadgetPort(const GadgetPort&) = delete;
  GadgetPort& operator=(const GadgetPort&) = delete;

  // Binds the gadget, which is what the box sees as a cable that was put in; does nothing where it is
  // plugged already. Errors: as HidGadget::Bind, and those of opening its file; it is then not bound.
  Result<void> Plug();
  // Pulls the cable: the box sees a device that is gone. What was not sent is lost.
  void Unplug();
  // The cable is in; whether the box has enumerated the device is not known here.
  bool plugged() const { return file_.valid(); }

  // Readable when the host sent a report; -1 while unplugged. The number changes with each Plug.
  int pollable() const { return file_.get(); }

  // Reads what the host sent; sends what is due. A host that fetches too slowly gets later reports
  // later. Takes at most 64 reports of the host at a time.
  void Pump(Time now);
  // When Pump has something to send; nothing while it has none. A host that fetches too
  // slowly is tried again after a millisecond.
  std::optional<Time> next_due(Time now) const;

 private:
  // Opens the file of the gadget, which is bound.
  Result<void> OpenFile();
  // False: the host has not fetched the one before. One report of f_hid is under way at a time.
  bool Send(const Report& report);

  HidGadget gadget_;
  // Its name in /sys/class/udc.
  std::string controller_;
  HidDevice& device_;
  UniqueFd file_;  // /dev/hidgN; invalid while unplugged.
  Report unsent_;  // The host fetches too slowly: it goes first.
};

}  // namespace kaori::sim
