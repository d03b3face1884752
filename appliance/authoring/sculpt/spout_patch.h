// The patch of the grid at the nose that a kettle draws out into a spout.
#pragma once

#include <glm/vec2.hpp>

#include "appliance/authoring/sculpt/half_topology.h"

namespace kaori::sculpt {

// Columns 0 to 3, rows 15 to 20 of the grid: between the mouth and the eyes.
inline constexpr Block kSpoutPatch{0, 3, 15, 20};

// Which part of the spout a vertex of the patch becomes: its foot on the kettle's wall, the rim of its hole,
// or the inside.
enum class SpoutPart : std::uint8_t { kFoot, kRim, kInside };

// Of the half's grid, its border included.
bool IsOnSpoutPatch(const Key& key);

// The patch as half a disc: x 0 (middle) .. 1 (side), y -1 (lower edge) .. 1 (upper edge).
glm::dvec2 OnSpoutDisc(const Key& key);

// By how far from the patch's middle the vertex lies on the square. The key must be on the patch.
SpoutPart SpoutPartOf(const Key& key);

}  // namespace kaori::sculpt
