// Whether the screen still shows the picture from before, while programs of the box end.
#pragma once

#include <string>

#include "drivers/base/result.h"
#include "hw-sim/hil/check.h"

namespace kaori::hil {

// Pictures that were looked at meanwhile.
struct HeldPicture {
  // Of the range of a byte, on average over a picture: breath, a blink and the hair's sway stay below.
  static constexpr double kMovedByItself = 0.06;

  // The file of the picture before.
  std::string face{};
  // How many were looked at since,
  int pictures = 0;
  // and how many of them were other pictures.
  int wrong = 0;
  // The difference of the worst of them.
  double largest = 0;

  // Compares the screen with the face before. Errors: those of the picture.
  Result<void> Look(Scene& scene);
};

// The face that is on the screen, to be held from now on; the picture is in the report. Errors: as Scene::ShootFace.
Result<HeldPicture> HoldFace(Scene& scene, const std::string& name, const std::string& caption);

}  // namespace kaori::hil
