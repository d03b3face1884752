// A smooth pull of space that takes some points exactly where they should go.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace kaori::sculpt {

struct Pull {
  glm::dvec3 from{};
  glm::dvec3 to{};
};

// Radial basis functions r (the biharmonic kernel of space) and an affine part.
class Warp {
 public:
  // Takes each pull exactly. None where pulls start at the same point, or all lie in one plane.
  static std::optional<Warp> Through(std::vector<Pull> pulls);

  glm::dvec3 operator()(glm::dvec3 p) const;

 private:
  std::vector<Pull> pulls_;
  std::vector<glm::dvec3> weight_;  // One for each pull, then four of the affine part: 1, x, y, z.
};

}  // namespace kaori::sculpt
