// The slit of a shut mouth, found without motion: lips touch in space and are far apart along the skin.
#pragma once

#include <vector>

#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/import/parts.h"

namespace kaori::import {

// Two vertices that face each other.
struct LipPair {
  Index upper = 0;
  Index lower = 0;
};

// Pairs from corner to corner; empty where lips are open, or have no slit between them. Eyes must be known.
std::vector<LipPair> LipsOf(const HeadShape& head, const MeshGraph& graph);

// The jaw turned open about its hinge below the ears: what lies nearer to the lower lip than to the upper one
// along the skin goes with it, least towards the hinge and down the neck; lower teeth and tongue go wholly.
Offsets JawByForm(const std::vector<PartOf>& part, const std::vector<LipPair>& lips, const HeadShape& head,
                  const MeshGraph& graph);

}  // namespace kaori::import
