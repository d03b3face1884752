// The locks of a head of hair: told apart by what triangles join, and put in the order in which they are
// drawn.
#pragma once

#include <cstddef>
#include <vector>

#include "render/face/cast.h"

namespace kaori::passes {

// For each vertex a number 0..1, the same for a whole lock (what triangles join), spread so that neighbours
// differ. Pure; nearly linear.
std::vector<float> LockNumbers(const face::Prop& hair);

// The triangles in the order in which they are drawn; those from `behind_from` on are of locks that lie behind the
// middle of the hair, of which the face hides most.
struct LockOrder {
  std::vector<face::Triangle> triangles;
  std::size_t behind_from = 0;
};

// The triangles with outer locks first, by a lock's farthest point from the upright axis through the middle
// of the hair: what they hide is then never shaded. A lock stays in one piece, so that its vertices stay in
// the cache; those behind come last. `numbers` as from LockNumbers.
LockOrder OuterLocksFirst(const face::Prop& hair, const std::vector<float>& numbers);

}  // namespace kaori::passes
