#include "appliance/authoring/appearance/tube.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

// Below 0 there are no stripes: hair.frag asks.
constexpr float kNoStrands = -100;
// Of the radius: how deep the grooves between the locks of gathered hair are.
constexpr float kRidgeDepth = 0.16F;
constexpr float kStep = 0.01F;

// The path's direction, by the difference of two points 2 % apart; one-sided at the ends.
glm::vec3 DirectionAt(const TubeShape& shape, float t) {
  return glm::normalize(shape.path(std::min(1.0F, t + kStep)) - shape.path(std::max(0.0F, t - kStep)));
}

// Rings lie closer at the ends, where they close.
float TubeRingAt(int ring, int rings) {
  if (ring == 0) return 0;
  if (ring == rings - 1) return 1;
  return static_cast<float>(ring - 1) / static_cast<float>(rings - 3);
}

// Carried along the path, so that the tube does not turn on itself.
glm::vec3 NextSide(glm::vec3 side, glm::vec3 along) {
  return glm::normalize(side - along * glm::dot(side, along));
}

// Any unit vector across `along`, by the axis that is farther from it.
glm::vec3 AnySide(glm::vec3 along) {
  const glm::vec3 other = std::abs(along.z) < 0.8F ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  return glm::normalize(glm::cross(along, other));
}

// A ridge is a half wave of a sine, so that locks are round and grooves sharp.
void AddRing(Patch& patch, const TubeShape& shape, float t, float radius_cm, glm::vec3 side) {
  const glm::vec3 along = DirectionAt(shape, t);
  const glm::vec3 front = glm::cross(side, along);
  for (int c = 0; c < shape.columns; ++c) {
    const float turn = 2 * kPi * static_cast<float>(c) / static_cast<float>(shape.columns);
    const float wound = turn + 2 * kPi * shape.twist_turns * t;
    const float ridge =
        shape.ridges > 0 ? std::abs(std::sin(0.5F * static_cast<float>(shape.ridges) * wound)) : 1;
    const float r = radius_cm * (1 - kRidgeDepth + kRidgeDepth * ridge);
    patch.points.push_back(shape.path(t) + r * (side * std::cos(turn) + front * std::sin(turn)));
  }
  patch.along.push_back(shape.strands ? t : 0);
}

}  // namespace

// A frame that is carried along the path (parallel transport), rather than Frenet's, which flips where the
// path is straight.
void AddTube(ClothMesh& mesh, const TubeShape& shape) {
  Patch patch{shape.rings, shape.columns, true, {}, {}, {}};
  glm::vec3 side = AnySide(DirectionAt(shape, 0));
  for (int ring = 0; ring < shape.rings; ++ring) {
    const float t = TubeRingAt(ring, shape.rings);
    const bool end = ring == 0 || ring == shape.rings - 1;
    side = NextSide(side, DirectionAt(shape, t));
    AddRing(patch, shape, t, end ? 0.0F : shape.radius_cm(t), side);
  }
  for (int c = 0; c < shape.columns; ++c) {
    patch.across.push_back(shape.strands ? static_cast<float>(c) / 6 : kNoStrands);
  }
  mesh.AddPatch(patch);
}

// By rows from the upper pole to the lower one.
void AddBall(ClothMesh& mesh, glm::vec3 centre_cm, glm::vec3 radii_cm) {
  constexpr int kRows = 13;
  constexpr int kColumns = 24;
  Patch ball{kRows, kColumns, true, {}, {}, {}};
  for (int row = 0; row < kRows; ++row) {
    const float down = kPi * static_cast<float>(row) / (kRows - 1);
    ball.along.push_back(0);
    for (int c = 0; c < kColumns; ++c) {
      const float around = 2 * kPi * static_cast<float>(c) / kColumns;
      ball.points.push_back(centre_cm + radii_cm * glm::vec3(std::sin(down) * std::sin(around),
                                                             std::cos(down),
                                                             std::sin(down) * std::cos(around)));
    }
  }
  ball.across.assign(kColumns, kNoStrands);
  mesh.AddPatch(ball);
}

}  // namespace kaori::appearance
