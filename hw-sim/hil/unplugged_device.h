// Unplugs a simulated device of the box for a scope, and plugs it in again afterwards.
#pragma once

#include <string>

#include "hw-sim/hil/check.h"

namespace kaori::hil {

// Plugs it in again also where the check fails in between: what a check or its control leaves unplugged would
// be missing in the next one.
class UnpluggedDevice {
 public:
  // Borrows the scene. `name` is one of sim::kUsbSockets. Waits `settles` afterwards, in which the box may
  // notice the loss.
  UnpluggedDevice(Scene& scene, std::string name, Duration settles = {})
      : scene_(scene), name_(std::move(name)) {
    static_cast<void>(scene_.target.rig().Unplug(name_));
    if (settles > Duration::zero()) scene_.target.For(settles);
  }
  ~UnpluggedDevice() { static_cast<void>(scene_.target.rig().Plug(name_)); }
  UnpluggedDevice(const UnpluggedDevice&) = delete;
  UnpluggedDevice& operator=(const UnpluggedDevice&) = delete;

 private:
  Scene& scene_;
  std::string name_;
};

}  // namespace kaori::hil
