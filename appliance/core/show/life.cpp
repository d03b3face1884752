#include "appliance/core/show/life.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace kaori::show {

// Within 60 degrees of straight ahead, so that eyes and head together reach it.
bool IsTarget(const glm::vec3& at_m) {
  return at_m.z >= kNearestTarget_m && glm::length(at_m) <= kFarthestTarget_m &&
         std::hypot(at_m.x, at_m.y) <= kSteepestTarget * at_m.z;
}

}  // namespace kaori::show
