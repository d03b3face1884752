// A unit of the box stands still for a while, and runs again afterwards.
#pragma once

#include <string>

#include "hw-sim/hil/check.h"

namespace kaori::hil {

class Lull {
 public:
  // Borrows the scene.
  Lull(Scene& scene, std::string unit) : scene_(scene), unit_(std::move(unit)) { Tell("stop"); }
  ~Lull() { Tell("start"); }
  Lull(const Lull&) = delete;
  Lull& operator=(const Lull&) = delete;

 private:
  // Where this fails the check sees it: the unit's work is still done, or is done no more.
  void Tell(const std::string& verb) {
    static_cast<void>(
        scene_.place.witness().Ask("own /usr/bin/systemctl " + verb + " " + unit_, std::chrono::minutes(2)));
  }

  Scene& scene_;
  std::string unit_;
};

}  // namespace kaori::hil
