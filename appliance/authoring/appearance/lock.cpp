#include "appliance/authoring/appearance/lock.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

// Point i round the lens, radians: from edge to edge over its face, and one behind, which nobody sees.
float RoundLens(const LockShape& s, int i) {
  return i > s.steps ? 1.5F * kPi : kPi * static_cast<float>(i) / static_cast<float>(s.steps);
}

constexpr float kBackDepth = 0.35F;  // The back is flatter than the face.

// Along the lock, with one ring close to the tip that shapes its end.
float RingAt(const LockShape& s, int ring) {
  if (ring == s.rings - 1) return 1;
  return 0.985F * HangingStep(static_cast<float>(ring) / static_cast<float>(s.rings - 2), s.hangs_from);
}

// Opens from the root to its full width, holds it, and tapers to the tip, which closes in a point at t = 1.
float WidthAt(const LockShape& s, float t) {
  if (t >= 1) return 0;
  const float opening = s.root + (1 - s.root) * SmoothStep(0, s.full_from, t);
  return s.width_cm * opening * (1 - (1 - s.tip) * SmoothStep(s.tapers_from, 1, t));
}

// A lock is thinnest at both ends; the numbers are parts of its thickness.
float ThicknessAt(const LockShape& s, float t) {
  if (t >= 1) return 0;
  return s.thickness_cm * (0.35F + 0.65F * SmoothStep(0, 0.4F, t)) * (1 - 0.8F * SmoothStep(0.7F, 1, t));
}

// `side` lies across the path in the scalp's tangent plane and `out` stands off it, so that the lens lies
// flat on the head however the path turns.
void AddRing(Patch& patch, const Skull& skull, const Path& path, const LockShape& shape, float t) {
  const glm::vec3 p = path(t);
  const glm::vec3 along = glm::normalize(path(std::min(1.0F, t + 0.01F)) - path(std::max(0.0F, t - 0.01F)));
  const glm::vec3 side = glm::normalize(glm::cross(OutwardsAt(skull, p), along));
  const glm::vec3 out = glm::cross(along, side);
  for (int i = 0; i < patch.columns; ++i) {
    const float c = std::cos(RoundLens(shape, i));
    const float s = std::sin(RoundLens(shape, i));
    const float depth = ThicknessAt(shape, t) * (s > 0 ? s : s * kBackDepth);
    patch.points.push_back(p - side * (c * 0.5F * WidthAt(shape, t)) + out * depth);
  }
  patch.along.push_back(t);
}

}  // namespace

// The section is closed across; the last ring closes in a point, and Quad leaves out what has no area there.
void AddLock(ClothMesh& mesh, const Skull& skull, const Path& path, const LockShape& shape) {
  Patch patch;
  patch.rows = shape.rings;
  patch.columns = shape.steps + 2;
  patch.closed_across = true;
  for (int i = 0; i < patch.columns; ++i) patch.across.push_back(0.5F - 0.5F * std::cos(RoundLens(shape, i)));
  for (int ring = 0; ring < shape.rings; ++ring) {
    AddRing(patch, skull, path, shape, RingAt(shape, ring));
  }
  mesh.AddPatch(patch);
}

}  // namespace kaori::appearance
