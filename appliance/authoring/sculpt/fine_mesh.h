// The fine mesh of the heads that are modelled here.
#pragma once

#include <vector>

#include "appliance/authoring/sculpt/cage.h"
#include "render/face/topology.h"

namespace kaori::sculpt {

// As mesh::Subdivide, with texture coordinates. `uvs_cm` are the cage's, in centimetres. The rows `from_cage` of
// the result interpolate any shape of the cage, so that all faces share one fine topology. Places are
// subdivided on the unrolled surface and only then mapped to the picture, whose map has knots.
face::FineMesh MakeFineMesh(const Cage& cage, const std::vector<glm::dvec2>& uvs_cm);

}  // namespace kaori::sculpt
