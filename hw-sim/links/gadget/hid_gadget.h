// A HID device as Linux shows it at its own USB socket: a gadget in configfs, made, bound and removed.
#pragma once

#include <string>

#include "drivers/base/result.h"
#include "hw-sim/devices/hid_device.h"

namespace kaori::sim {

// Where the kernel keeps gadgets and their files; tests have folders of their own.
struct GadgetRoom {
  // A folder of configfs.
  std::string gadgets = "/sys/kernel/config/usb_gadget";
  // Where /dev/hidgN appear.
  std::string devices = "/dev";
};

// One gadget with one function, as Documentation/usb/gadget_configfs.rst describes it. Needs root, and a
// kernel with libcomposite and usb_f_hid. The gadget goes with this.
class HidGadget {
 public:
  // Makes it, not yet bound; what a simulator that was killed left under that name is used again. `name`
  // is a folder's name. Errors: those of the files: permission_denied, no_such_file_or_directory
  // (configfs is not mounted), and whatever the kernel says of a value.
  static Result<HidGadget> Make(GadgetRoom room, const std::string& name, const HidDeviceName& identity);
  HidGadget(HidGadget&& other) noexcept
      : room_(std::move(other.room_)), path_(std::exchange(other.path_, {})) {}
  HidGadget& operator=(HidGadget&&) = delete;
  ~HidGadget();

  // The cable: to the USB device controller of that name, as in /sys/class/udc. Errors:
  // device_or_resource_busy (another gadget has it), no_such_device.
  Result<void> Bind(const std::string& controller);
  // Takes it off its controller; does nothing where it is not bound.
  void Unbind();

  // The file through which its reports go, "/dev/hidg0"; there is one while it is bound. Reading it
  // gives output reports, writing to it sends input reports. Errors: those of the gadget's own file.
  Result<std::string> DeviceFile() const;

 private:
  HidGadget(GadgetRoom room, std::string path) : room_(std::move(room)), path_(std::move(path)) {}
  // Writes the descriptors' values, and puts the function into the configuration.
  Result<void> Describe(const HidDeviceName& identity) const;

  GadgetRoom room_;
  std::string path_;  // The gadget's folder in configfs; empty: it was moved away.
};

}  // namespace kaori::sim
