// Another device at one of the box's USB sockets, for a scope.
#pragma once

#include <string>

#include "hw-sim/hil/check.h"

namespace kaori::hil {

// The rig's own device comes back afterwards, also where the check fails in between.
// One at a time at a socket. One thread: that of the waiter.
class HeldDevice {
 public:
  // Borrows the scene and the device. `socket` is one of sim::kUsbSockets. The box is given time to see that its
  // own device went before the other one comes.
  HeldDevice(Scene& scene, std::string socket, sim::UsbDevice& device)
      : scene_(scene), socket_(std::move(socket)) {
    static_cast<void>(rig().Unplug(socket_));
    scene_.target.For(kNoticed);
    static_cast<void>(rig().Hold(socket_, &device));
    static_cast<void>(rig().Plug(socket_));
  }
  ~HeldDevice() {
    static_cast<void>(rig().Unplug(socket_));
    scene_.target.For(kNoticed);
    static_cast<void>(rig().Hold(socket_, nullptr));
    static_cast<void>(rig().Plug(socket_));
  }
  HeldDevice(const HeldDevice&) = delete;
  HeldDevice& operator=(const HeldDevice&) = delete;

  // The cable, while it is held. Neither waits: the box notices within a second, and so does the device.
  void Pull() { static_cast<void>(rig().Unplug(socket_)); }
  void Plug() { static_cast<void>(rig().Plug(socket_)); }

 private:
  // Longer than the kernel and the box's input program take to see that a device has gone.
  static constexpr Duration kNoticed = std::chrono::seconds(1);
  sim::UsbRig& rig() { return scene_.target.rig(); }

  Scene& scene_;
  std::string socket_;
};

}  // namespace kaori::hil
