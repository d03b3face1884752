#include "appliance/authoring/sculpt/fit_lids.h"

#include <glm/geometric.hpp>

namespace kaori::sculpt {
namespace {

// How far ring 7 lies under the ball's surface at least.
constexpr double kSunk_cm = 0.45;

// Along the ray from the ball's centre.
glm::dvec3 AtRadius(const Ball& ball, glm::dvec3 p, double radius) {
  return ball.centre + glm::normalize(p - ball.centre) * radius;
}

// The edge and the ring behind it are set; the skin before them is only pushed out, and the ring in the ball only in.
void FitRing(const HalfTopology& half, const Ball& ball, int k, double radius, HalfShape& shape) {
  for (int j = 0; j < kEyeRim; ++j) {
    glm::dvec3& p = shape.position[half.At(Region::kEye, j, k)];
    const double off = glm::distance(p, ball.centre) - radius;
    const bool lies_well = k < kLidRing ? off >= 0 : k > kLidRing + 1 && off <= 0;
    if (!lies_well) p = AtRadius(ball, p, radius);
  }
}

}  // namespace

// Rings are fitted one by one; none depends on another.
void FitLids(const HalfTopology& half, const Ball& ball, double skin_cm, HalfShape& shape) {
  const double edge = ball.radius + ball.lid_thickness;
  for (int k = 1; k < kLidRing; ++k) FitRing(half, ball, k, ball.radius + skin_cm, shape);
  FitRing(half, ball, kLidRing, edge, shape);
  FitRing(half, ball, kLidRing + 1, ball.radius, shape);
  FitRing(half, ball, kLidRing + 2, ball.radius - kSunk_cm, shape);
}

}  // namespace kaori::sculpt
