// Folds: triangles of the skin that an expression has turned over.
#pragma once

#include <span>
#include <vector>

#include "render/face/composer.h"

namespace kaori::inspect {

struct Folds {
  std::vector<std::size_t> triangles;  // Of the fine mesh.
  glm::vec3 at{};                      // The first one's middle, metres.
};

// Triangles of the skin that look away from all that surrounds them, by more than a right angle. `twin` as in
// FineMesh; `skin` as from FindSkin.
Folds FindFolds(std::span<const glm::vec3> fine, const face::FineMesh& mesh, const std::vector<bool>& skin);

}  // namespace kaori::inspect
