// The PC's own power button, as the kernel's input layer has it (ACPI, evdev).
#pragma once

#include <filesystem>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::power {

// One of the machine's own buttons that powers it: a key KEY_POWER on a device of the bus HOST, and no
// keyboard, whose power key anybody may plug in. Non-blocking. One thread.
class PowerButton {
 public:
  // Takes a descriptor that gives struct input_event, as evdev's devices do.
  explicit PowerButton(UniqueFd device) : device_(std::move(device)) {}

  // Those of the machine, in the order of their names; a device that cannot be opened or asked is none of
  // them. Blocks for the file system.
  static std::vector<PowerButton> FindAll(const std::filesystem::path& folder = "/dev/input");

  // Reads all events that wait. Whether the button went down since the last call; its release, and the
  // repetition while it is held, are no press. Errors: no_such_device, the device is gone; those of read(2).
  Result<bool> ReadPress();

  int fd() const { return device_.get(); }

 private:
  UniqueFd device_;
};

}  // namespace kaori::power
