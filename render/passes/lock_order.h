// The locks of a head of hair: told apart by what triangles join, and put in the order in which they are
// drawn.
#pragma once

#include <vector>

#include "render/face/cast.h"

namespace kaori::passes {

// For each vertex a number 0..1, the same for a whole lock (what triangles join), spread so that neighbours
// differ. Pure; nearly linear.
std::vector<float> LockNumbers(const face::Prop& hair);

// The triangles with outer locks first, by a lock's farthest point from the upright axis through the middle
// of the hair: what they hide is then never shaded. A lock stays in one piece, so that its vertices stay in
// the cache. `numbers` as from LockNumbers.
std::vector<face::Triangle> OuterLocksFirst(const face::Prop& hair, const std::vector<float>& numbers);

}  // namespace kaori::passes
