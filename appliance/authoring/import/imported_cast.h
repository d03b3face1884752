// A cast of imported heads: topology, control net, faces.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/import/heads.h"
#include "appliance/authoring/import/point_choice.h"
#include "render/face/cast.h"

namespace kaori::import {

// A shape that is to become an expression of the cast; offsets in metres by skin vertex of the first head.
struct WantedShape {
  // Unique among all that are wanted.
  std::string name;
  face::ExpressionKind kind = face::ExpressionKind::kChannel;
  Offsets offsets;  // Empty: nothing moves.
  float pupil = 1;  // As face::Expression has it.
};

// Puts the vertices that any wanted shape moves by more than 0.01 mm first, in heads and shapes alike, and
// keeps the order otherwise. Returns their number. The cast's interpolant then has rows for those alone
// (Topology::moving_count), and the frame leaves the back of the head and the neck untouched.
Index OrderByMotion(Heads& heads, std::vector<WantedShape>& shapes);

// Everything of the cast but its expressions and its look: topology, control net, faces with eyes of a plain
// brown, neck and mouth anchors. Heads must be in the order of OrderByMotion; `moving` is what it returned.
// The lids have no rings, as those of the show's own topology have: expressions shut them (Cast::blink).
face::Cast MakeCast(const Heads& heads, const std::vector<WantedShape>& shapes, Index moving,
                    const PointOptions& options);

}  // namespace kaori::import
