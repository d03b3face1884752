// Folds: triangles of the skin that an expression has turned over.
#pragma once

#include <span>
#include <vector>

#include "render/face/composer.h"

namespace kaori::inspect {

// What FindFolds found; no triangles: no fold.
struct Folds {
  // Numbers of FineMesh::triangles.
  std::vector<std::size_t> triangles;
  // The first one's middle, metres.
  glm::vec3 at{};
};

// Triangles of the skin that look away from all that surrounds them, by more than 107 degrees. What
// surrounds a triangle is the sum of the unit normals about its three corners but its own, with seams closed
// by `twin` as in FineMesh. `fine` are the positions of the fine mesh in some pose; `skin` is by triangle,
// as from FindSkin. O(triangles).
Folds FindFolds(std::span<const glm::vec3> fine, const face::FineMesh& mesh, const std::vector<bool>& skin);

}  // namespace kaori::inspect
