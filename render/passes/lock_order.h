// The locks of a head of hair: told apart by what triangles join, and put in the order in which they are
// drawn.
#pragma once

#include <vector>

#include "render/face/cast.h"

namespace kaori::passes {

// For each vertex a number 0..1, the same for a whole lock, spread so that neighbours differ.
std::vector<float> LockNumbers(const face::Prop& hair);

// Outer locks first: what they hide is then never shaded. A lock stays in one piece, so that its vertices
// stay in the cache.
std::vector<face::Triangle> OuterLocksFirst(const face::Prop& hair, const std::vector<float>& numbers);

}  // namespace kaori::passes
