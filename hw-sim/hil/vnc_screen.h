// A screen that is plugged into an output of the virtual machine. QEMU's VNC server takes the size that its
// viewer asks for as that of the screen; RFC 6143, and its extension SetDesktopSize.
#pragma once

#include <string>

#include "hw-sim/hil/stream.h"

namespace kaori::hil {

// One session with one output of the machine, which ends with the object. Movable. One thread: that of
// the waiter.
class VncScreen {
 public:
  // Begins a session with the server of one output. The waiter outlives it. Errors: timed_out,
  // no_such_device.
  static Result<VncScreen> Connect(const std::string& path, Waiter& waiter);

  // Plugs in a screen of that size instead of the one before; 0 by 0: none. Errors: no_such_device.
  Result<void> Resize(int width_px, int height_px);

 private:
  VncScreen(Stream stream, Waiter& waiter) : stream_(std::move(stream)), waiter_(&waiter) {}
  // Waits a minute at most for so many bytes. Errors: timed_out, no_such_device.
  Result<std::string> Next(std::size_t bytes);
  // The handshake: version, security, and the encodings that this client understands.
  Result<void> Greet();

  Stream stream_;
  Waiter* waiter_;
};

}  // namespace kaori::hil
