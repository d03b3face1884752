// Lids laid onto a ball anew, after their rings were bent with the rest of a face.
#pragma once

#include "appliance/authoring/sculpt/cage.h"

namespace kaori::sculpt {

// An eyeball, in centimetres.
struct Ball {
  glm::dvec3 centre{};
  double radius = 0;
  // How far the lid's edge stands above it.
  double lid_thickness = 0;
};

// How far the skin before the lid's edge stands over it at least, where the whole head was bent: that leaves some of it
// inside the ball.
inline constexpr double kSkinOverLid_cm = 0.05;

// The lid's edge (ring 5) goes to its thickness above the ball and ring 6 onto it; ring 7 is pushed into it where it
// lies less deep, and the rings before the edge are pushed out where they stand less than `skin_cm` over it. All along the
// ray from the ball's centre; nothing may lie there.
void FitLids(const HalfTopology& half, const Ball& ball, double skin_cm, HalfShape& shape);

}  // namespace kaori::sculpt
