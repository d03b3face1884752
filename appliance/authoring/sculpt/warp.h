// A smooth pull of space that takes some points exactly where they should go.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace kaori::sculpt {

// A point, and where it goes; any unit, as long as all pulls share it.
struct Pull {
  glm::dvec3 from{};
  glm::dvec3 to{};
};

// Radial basis functions r (the biharmonic kernel of space) and an affine part. Beyond its pulls it goes on
// smoothly, ever closer to the affine part. Owns its pulls.
class Warp {
 public:
  // Takes each pull exactly. None where pulls start at the same point, or all lie in one plane: the matrix is
  // then singular. O(n^3) in the pulls.
  static std::optional<Warp> Through(std::vector<Pull> pulls);

  // Where `p` goes. O(n).
  glm::dvec3 operator()(glm::dvec3 p) const;

 private:
  std::vector<Pull> pulls_;
  // One for each pull, then four of the affine part: 1, x, y, z.
  std::vector<glm::dvec3> weight_;
};

}  // namespace kaori::sculpt
