// Starts the image in QEMU for a person to look at: `kaori-bench --boot`, which is `./box boot`.
#pragma once

#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "hw-sim/hil/qemu_command.h"

namespace kaori::hil {

// What to do beside running the machine; both may be asked for.
struct BootOptions {
  // Prints on the way where the time goes, from the start of QEMU to the first face, and ends.
  bool trace = false;
  // Writes a picture of the screen (PNG) once the first face is there, and ends. Empty: none.
  std::string shot{};
};

// Runs the machine until it has shown what was asked for, or until it ends by itself: without either it
// runs until its window is closed. Blocks all the while. Errors: those of QemuDriver::On; timed_out and
// no_such_device, where the face does not come.
Result<void> Boot(QemuOptions machine, const BootOptions& options, const Clock& clock);

}  // namespace kaori::hil
