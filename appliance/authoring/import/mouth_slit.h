// The slit of a shut mouth, found without motion: lips touch in space and are far apart along the skin.
#pragma once

#include <vector>

#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/import/parts.h"

namespace kaori::import {

// Two vertices that face each other across the slit.
struct LipPair {
  Index upper = 0;
  Index lower = 0;
};

// One pair for each vertex of the upper lip that has a partner, in the order of vertices, not of place. Empty
// where the lips are open, or have no slit between them (a mouth that is painted on), where no nose was
// found, where there are fewer than four pairs or none near the middle. Both eyes must be known; `graph` is
// of `head`. Runs a short search along the skin for each vertex about the mouth.
std::vector<LipPair> LipsOf(const HeadShape& head, const MeshGraph& graph);

// The jaw turned open by 0.28 rad (16 degrees) about its hinge below the ears: what lies nearer to the lower
// lip than to the upper one along the skin goes with it, least towards the hinge and down the neck; lower
// teeth and tongue go wholly, upper teeth not at all. `part` is by vertex of `head`; `lips` must not be
// empty. Offsets by vertex, metres: the end of the arc.
Offsets JawByForm(const std::vector<PartOf>& part, const std::vector<LipPair>& lips, const HeadShape& head,
                  const MeshGraph& graph);

}  // namespace kaori::import
