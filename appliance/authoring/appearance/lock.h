// One lock of hair: a lens-shaped tube along a path, that tapers to its tip.
#pragma once

#include <functional>

#include "appliance/authoring/appearance/cloth_mesh.h"
#include "appliance/authoring/appearance/skull.h"

namespace kaori::appearance {

// Sizes of a lock in the middle, and how it changes along its length, 0 at the root and 1 at the tip.
struct LockShape {
  // The lens is this wide and this thick where it is full; its face is rounder than its back.
  float width_cm = 2;
  float thickness_cm = 0.4F;
  // Width at the root, as a part of the width.
  float root = 0.3F;
  // The full width is reached here along the lock, and left at `tapers_from`.
  float full_from = 0.45F;
  float tapers_from = 0.7F;
  // Width just before the tip closes, as a part of the width.
  float tip = 0.05F;
  // Cross-sections from root to tip; 3 at least.
  int rings = 11;
  // Up to here it lies on the skull, where it has a little over half of its rings; from here on it
  // hangs. 1: rings are even.
  float hangs_from = 1;
  // Steps over its face; 2 at least. Fewer are enough for a narrow one.
  int steps = 5;
};

// The middle of the lock: t 0 at the root .. 1 at the tip; centimetres.
using Path = std::function<glm::vec3(float t)>;

// Adds shape.rings times shape.steps + 2 points. `path` is asked for points a little before and after t, too, always
// within 0 .. 1; it must not stand still. The skull says which way is outwards.
void AddLock(ClothMesh& mesh, const Skull& skull, const Path& path, const LockShape& shape);

}  // namespace kaori::appearance
