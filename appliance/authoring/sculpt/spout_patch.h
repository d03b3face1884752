// The patch of the grid at the nose that a kettle draws out into a spout.
#pragma once

#include <glm/vec2.hpp>

#include "appliance/authoring/sculpt/half_topology.h"

namespace kaori::sculpt {

inline constexpr Block kSpoutPatch{0, 3, 15, 20};

enum class SpoutPart : std::uint8_t { kFoot, kRim, kInside };

bool IsOnSpoutPatch(const Key& key);

// The patch as half a disc: x 0 (middle) .. 1 (side), y -1 (lower edge) .. 1 (upper edge).
glm::dvec2 OnSpoutDisc(const Key& key);

// The key must be on the patch.
SpoutPart SpoutPartOf(const Key& key);

}  // namespace kaori::sculpt
