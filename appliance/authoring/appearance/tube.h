// A tube along a path, closed at both ends: a rod, a ring, gathered hair.
#pragma once

#include <functional>

#include "appliance/authoring/appearance/cloth_mesh.h"

namespace kaori::appearance {

// A tube by its middle line and its radius along it. What `path` and `radius_cm` borrow must live
// until AddTube returns.
struct TubeShape {
  // t 0 .. 1; centimetres. Ends must not lie on each other.
  std::function<glm::vec3(float)> path;
  // Over t.
  std::function<float(float)> radius_cm;
  // Cross-sections along it, and points round each.
  int rings = 16;
  int columns = 12;
  // Locks side by side; 0: round.
  int ridges = 0;
  // The ridges wind so far from end to end.
  float twist_turns = 0;
  // Drawn as hair: striped, and swinging at its tip.
  bool strands = false;
};

// Adds rings * columns points; both ends close in a point. 4 rings at least.
void AddTube(ClothMesh& mesh, const TubeShape& shape);

// A ball with three radii, its poles along y; without strands.
void AddBall(ClothMesh& mesh, glm::vec3 centre_cm, glm::vec3 radii_cm);

}  // namespace kaori::appearance
