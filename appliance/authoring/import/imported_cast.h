// A cast of imported heads: topology, control net, faces.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/import/heads.h"
#include "appliance/authoring/import/point_choice.h"
#include "render/face/cast.h"

namespace kaori::import {

// A shape that is to become an expression; offsets by skin vertex of the first head.
struct WantedShape {
  std::string name;
  face::ExpressionKind kind = face::ExpressionKind::kChannel;
  Offsets offsets;  // Empty: nothing moves.
};

// Puts the vertices that any wanted shape moves first, in heads and shapes alike. Returns their number.
Index OrderByMotion(Heads& heads, std::vector<WantedShape>& shapes);

// Everything of the cast but its expressions and its look. Heads must be in the order of OrderByMotion;
// `moving` is what it returned. Lids have no rings: expressions shut them.
face::Cast MakeCast(const Heads& heads, const std::vector<WantedShape>& shapes, Index moving,
                    const PointOptions& options);

}  // namespace kaori::import
