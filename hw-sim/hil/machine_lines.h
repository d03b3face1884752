// Levels on the GPIO lines of a machine's own controller: what a hand does at encoders and switches that are wired to it.
#pragma once

#include <string>

#include "drivers/base/result.h"
#include "hw-sim/hil/qmp.h"
#include "hw-sim/hil/stream.h"

namespace kaori::hil {

// By QEMU's own test protocol (qtest), beside a machine that runs: the controller sees a level change and interrupts, as by a
// wire. One thread: that of the waiter.
class MachineLines {
 public:
  // ARM's PL061 has eight lines. The fourth of QEMU's machine virt is its power button.
  static constexpr int kLines = 8;

  // `path` is the socket of the protocol; `monitor` finds the controller. Errors: those of both; no_such_device, the machine
  // has no PL061.
  static Result<MachineLines> Open(const std::string& path, Qmp& monitor, Waiter& waiter);

  // Returns when the controller has the level; what the machine makes of it comes later. Errors: invalid_argument (QEMU's own
  // words), timed_out, no_such_device.
  Result<void> Set(int line, bool high);

 private:
  MachineLines(Stream stream, std::string controller, Waiter& waiter)
      : stream_(std::move(stream)), controller_(std::move(controller)), waiter_(&waiter) {}

  Stream stream_;
  std::string controller_;  // Its path in QEMU's tree of objects.
  Waiter* waiter_;
};

}  // namespace kaori::hil
