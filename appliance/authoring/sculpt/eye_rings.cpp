#include "appliance/authoring/sculpt/eye_rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

namespace kaori::sculpt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kHalfRim = kEyeRim / 2;
// Rings 1 to 3 are skin and are smoothed; nearer the lid the shape is exact.
constexpr int kSmoothRings = 3;
// Enough to round off the corners of the square block in the skin about the eye.
constexpr int kEyeRingsSmoothSteps = 14;
// How far ring 4 stands over the fold.
constexpr double kLiftOverFold_cm = 0.03;
// How far rings 0 to 5 lie on the way from the square rim in the grid to the lid's edge: closer together near
// the lid, which bends most when it shuts.
constexpr std::array<double, kLidRing + 1> kTowardsLid{0, 0.26, 0.50, 0.70, 0.86, 1.0};

using RimRing = std::array<glm::dvec2, kEyeRim>;
using Rings = std::array<RimRing, kLidRing + 1>;

bool IsUpper(int j) {
  return j <= kHalfRim;
}
// 0 at the inner corner, 1 at the outer one, along the upper lid (j 0 .. 14) and back along the lower one.
double AlongLid(int j) {
  return static_cast<double>(IsUpper(j) ? j : kEyeRim - j) / kHalfRim;
}
// 0 in the corners, 1 in the middle of a lid.
double Bow(int j) {
  return std::sin(kPi * AlongLid(j));
}

// The lid's edge, position by position.
RimRing LidRing(const EyeRecipe& eye) {
  RimRing lid;
  for (int j = 0; j < kEyeRim; ++j) lid[static_cast<std::size_t>(j)] = LidCurve(eye, AlongLid(j), IsUpper(j));
  return lid;
}

// One step of smoothing: 0.5 of itself, 0.2 of each neighbour along the ring, 0.05 of each across.
glm::dvec2 SmoothedPoint(const Rings& rings, std::size_t k, std::size_t j) {
  const RimRing& ring = rings[k];
  const glm::dvec2 along = ring[(j + 1) % kEyeRim] + ring[(j + kEyeRim - 1) % kEyeRim];
  const glm::dvec2 across = rings[k - 1][j] + rings[k + 1][j];
  const glm::dvec2 target = 0.5 * ring[j] + 0.2 * along + 0.05 * across;
  // At the pointed corners rings would cross each other if they were smoothed freely.
  const double freedom = std::clamp(2 * Bow(static_cast<int>(j)), 0.12, 1.0);
  return glm::mix(ring[j], target, freedom);
}

// Rounds the square rim off on its way to the lid, and keeps the spacing across.
void Smooth(Rings& rings) {
  for (int step = 0; step < kEyeRingsSmoothSteps; ++step) {
    const Rings before = rings;
    for (std::size_t k = 1; k <= kSmoothRings; ++k) {
      for (std::size_t j = 0; j < kEyeRim; ++j) {
        const glm::dvec2 straight = glm::mix(before[0][j], before[kLidRing][j], kTowardsLid[k]);
        rings[k][j] = glm::mix(SmoothedPoint(before, k, j), straight, 0.4);
      }
    }
  }
}

// Rings 0 to 5, for positions and for uv alike: the unrolled surface is made by the same steps.
Rings Between(const RimRing& rim, const RimRing& lid) {
  Rings rings;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    for (std::size_t j = 0; j < kEyeRim; ++j) rings[k][j] = glm::mix(rim[j], lid[j], kTowardsLid[k]);
  }
  Smooth(rings);
  return rings;
}

// The front of a sphere about the ball's centre, over (x, y). Beyond the sphere's outline, and just within
// it, a point a little before the centre (sqrt(0.02) cm): the lid's corners reach there.
glm::dvec3 OnSphere(const EyeRecipe& eye, glm::dvec2 p, double radius) {
  const double dx = p.x - eye.centre.x;
  const double dy = p.y - eye.centre.y;
  return {p, eye.centre.z + std::sqrt(std::max(radius * radius - dx * dx - dy * dy, 0.02))};
}

// Ring 3 of the upper lid is sunk into the crease, ring 4 stands over it: the fold from which a lid unrolls.
glm::dvec3 SkinPoint(const std::vector<Body>& bodies, const EyeRecipe& eye, glm::dvec2 p, int j, int k) {
  glm::dvec3 on_skin = Project(bodies, {p, 6.5}, {0, 0, 1});
  if (k == 3 && IsUpper(j)) on_skin.z -= eye.crease * Bow(j);
  if (k == 4) on_skin.z += kLiftOverFold_cm * Bow(j);
  return on_skin;
}

// Rings 6 and 7 close the gap between the lid and the ball. Ring 6 lies on the ball, ring 7 within it, 10 %
// wider than the lid's opening and 3 mm farther back, so that no light falls through between lid and ball
// from any side.
glm::dvec3 BehindLid(const EyeRecipe& eye, glm::dvec2 lid, int k) {
  if (k == kLidRing + 1) return OnSphere(eye, lid, eye.radius);
  const glm::dvec2 centre(eye.centre);
  return OnSphere(eye, centre + (lid - centre) * 1.1, eye.radius - 0.5) - glm::dvec3(0, 0, 0.3);
}

// In the unrolled surface an open eye is a hole; what lies behind the lid shrinks into it.
glm::dvec2 UvInHole(const EyeRecipe& eye, glm::dvec2 lid, int k) {
  const glm::dvec2 middle(0.5 * (eye.inner_x + eye.outer_x), 0.5 * (eye.inner_y + eye.outer_y));
  return middle + (lid - middle) * (k == kLidRing + 1 ? 0.93 : 0.8);
}

}  // namespace

// The straight line between the corners, plus an arch that is 0 at both.
glm::dvec2 LidCurve(const EyeRecipe& eye, double s, bool upper) {
  // s is mixed with its cosine, which puts more vertices into the corners, where the curve turns.
  const double t = 0.55 * s + 0.45 * (1 - std::cos(kPi * s)) / 2;
  const glm::dvec2 inner(eye.inner_x, eye.inner_y);
  const glm::dvec2 outer(eye.outer_x, eye.outer_y);
  // sin() of pi is a hair below 0, and a power of that is no number.
  const auto arch = [t](double skew, double bluntness) {
    return std::pow(std::max(std::sin(kPi * std::pow(t, skew)), 0.0), bluntness);
  };
  // The upper lid is highest a little inwards of its middle (skew 0.92) and nearly flat there (bluntness
  // below 1); the lower lid is lowest outwards of its middle.
  const double height = upper ? eye.upper_height * arch(0.92, 0.72) : -eye.lower_height * arch(1.12, 0.85);
  return glm::mix(inner, outer, t) + glm::dvec2(0, height);
}

// First all rings in the plane, seen from the front; then each gets its depth: the skin's, the ball's,
// or behind it.
void PlaceEyeRings(const HalfTopology& half, const std::vector<Body>& bodies, const EyeRecipe& eye,
                   HalfShape& shape) {
  const RimRing lid = LidRing(eye);
  RimRing rim;
  RimRing rim_uv_cm;
  for (std::size_t j = 0; j < kEyeRim; ++j) {
    const Index vertex = half.At(Region::kEye, static_cast<int>(j), 0);
    rim[j] = glm::dvec2(shape.position[vertex]);
    rim_uv_cm[j] = shape.uv_cm[vertex];
  }
  const Rings rings = Between(rim, lid);
  const Rings uvs_cm = Between(rim_uv_cm, lid);
  for (int k = 1; k <= kEyeRings; ++k) {
    for (int j = 0; j < kEyeRim; ++j) {
      const auto at = static_cast<std::size_t>(j);
      const auto ring = static_cast<std::size_t>(std::min(k, kLidRing));
      const Index vertex = half.At(Region::kEye, j, k);
      shape.uv_cm[vertex] = k <= kLidRing ? uvs_cm[ring][at] : UvInHole(eye, lid[at], k);
      if (k < kLidRing) {
        shape.position[vertex] = SkinPoint(bodies, eye, rings[ring][at], j, k);
      } else if (k == kLidRing) {
        shape.position[vertex] = OnSphere(eye, lid[at], eye.radius + eye.thickness);
      } else {
        shape.position[vertex] = BehindLid(eye, lid[at], k);
      }
    }
  }
}

}  // namespace kaori::sculpt
