// Stops a systemd unit of the box for a scope, and starts it again afterwards.
#pragma once

#include <string>

#include "hw-sim/hil/check.h"

namespace kaori::hil {

// Stops with systemctl and starts again at the end, also where the check fails. Blocks while
// systemd does it, two minutes at most.
// One thread: that of the waiter.
class PausedUnit {
 public:
  // Borrows the scene. `unit` is a name as systemctl takes it: "kaori-stage.service". A unit that was not running is
  // started all the same at the end.
  PausedUnit(Scene& scene, std::string unit) : scene_(scene), unit_(std::move(unit)) { Tell("stop"); }
  ~PausedUnit() { Tell("start"); }
  PausedUnit(const PausedUnit&) = delete;
  PausedUnit& operator=(const PausedUnit&) = delete;

 private:
  // Where this fails the check sees it: the unit's work is still done, or is done no more.
  void Tell(const std::string& verb) {
    static_cast<void>(
        scene_.target.agent().Ask("own /usr/bin/systemctl " + verb + " " + unit_, std::chrono::minutes(2)));
  }

  Scene& scene_;
  std::string unit_;
};

}  // namespace kaori::hil
