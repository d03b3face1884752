// Lids laid onto a ball anew, after their rings were bent with the rest of a face.
#pragma once

#include "appliance/authoring/sculpt/cage.h"

namespace kaori::sculpt {

struct Ball {
  glm::dvec3 centre{};
  double radius = 0;
  double lid_thickness = 0;
};

// The lid's edge goes to its thickness above the ball, the rings behind it onto and into the ball; the two
// rings before it are pushed out where they would cut into it.
void SeatLids(const HalfTopology& half, const Ball& ball, HalfShape& shape);

}  // namespace kaori::sculpt
