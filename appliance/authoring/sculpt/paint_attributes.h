// What the painter of textures knows of each vertex of the cage besides its uv.
#pragma once

#include <vector>

#include "appliance/authoring/sculpt/cage.h"

namespace kaori::sculpt {

// Interpolate these over a triangle, and lips and lids are painted exactly along the loops of the mesh,
// however the unrolled surface is distorted.
struct PaintAttributes {
  // Ring of the eye 1 .. 7, 0 elsewhere; positive above the eye, negative below it.
  float eye_ring = 0;
  float mouth_ring =
      0;  // Ring of the mouth 1 .. 6, and 6 in the bag behind it; positive above, negative below.
  // 1 inside the mouth, 0 elsewhere.
  float bag = 0;
  // 0 on the head .. 1 on the innermost ring and the cap of the ear.
  float ear_ring = 0;
  // 1 in the hole of a kettle's spout, 0.5 on its rim.
  float spout = 0;
};

// One for each vertex of the cage. A pure function of the topology: all faces share it.
std::vector<PaintAttributes> PaintAttributesOf(const Cage& cage);

}  // namespace kaori::sculpt
