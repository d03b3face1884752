// Listens to the kernel's uevents for screens that are plugged into a graphics card, or pulled. udev is
// not needed, so that it also works before udev runs and within a sandbox that lets netlink through.
#pragma once

#include <span>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::scanout {

// Whether a uevent reports a screen that came or went. `uevent` is as the kernel sends it:
// strings, each with a zero behind it, "change@/devices/..." first, then "NAME=value". Bytes that
// make no sense are no such report. Pure.
bool IsScreenHotplug(std::span<const char> uevent);

// Some cards notice by themselves what is plugged into them, others only when they are probed. All of them
// report a uevent when it is time to probe. One thread.
class HotplugMonitor {
 public:
  // Opens a netlink socket and listens from now on; what happened before is not told. Errors: those of
  // socket(2) and bind(2), as where a sandbox forbids it.
  static Result<HotplugMonitor> Open();
  HotplugMonitor() = default;  // Hears nothing.

  // Reads every uevent that waits; true where one of them
  // reports a screen, or some were lost. Does not block.
  bool Drain();

 private:
  explicit HotplugMonitor(UniqueFd socket) : socket_(std::move(socket)) {}

  UniqueFd socket_;
};

}  // namespace kaori::scanout
