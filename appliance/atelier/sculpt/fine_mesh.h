// One step of Catmull-Clark subdivision as a fixed matrix from the cage (Catmull and Clark 1978).
#pragma once

#include <vector>

#include "appliance/atelier/sculpt/cage.h"
#include "render/face/topology.h"

namespace kaori::sculpt {

// Fine vertices: the cage's, then one for each quad, then one for each edge. Seams are closed: the copies on
// either side get the same rows. `places` are the cage's, in centimetres.
face::FineMesh Subdivide(const Cage& cage, const std::vector<glm::dvec2>& places);

}  // namespace kaori::sculpt
