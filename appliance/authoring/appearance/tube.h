// A tube along a path, closed at both ends: a rod, a ring, gathered hair.
#pragma once

#include <functional>

#include "appliance/authoring/appearance/cloth_mesh.h"

namespace kaori::appearance {

struct TubeShape {
  std::function<glm::vec3(float)> path;   // t 0 .. 1; centimetres. Ends must not lie on each other.
  std::function<float(float)> radius_cm;  // Over t.
  int rings = 16;
  int columns = 12;
  int ridges = 0;         // Locks side by side; 0: round.
  float twist_turns = 0;  // The ridges wind so far from end to end.
  bool strands = false;   // Drawn as hair: striped, and swinging at its tip.
};

void AddTube(ClothMesh& mesh, const TubeShape& shape);

// A ball with three radii.
void AddBall(ClothMesh& mesh, glm::vec3 centre_cm, glm::vec3 radii_cm);

}  // namespace kaori::appearance
