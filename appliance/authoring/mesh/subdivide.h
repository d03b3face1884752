// One step of Catmull-Clark subdivision as a fixed matrix from the cage (Catmull and Clark 1978).
#pragma once

#include <vector>

#include "render/face/topology.h"

namespace kaori::mesh {

using face::Index;
// Three corners or more, counter-clockwise seen from outside. All polygons of a mesh must agree in this.
using Polygon = std::vector<Index>;

// For each vertex the other copy at its position, where there are just two; itself elsewhere. Of three copies
// the first two are a pair. `weld`: for each vertex the first one at its position. Normals are averaged over
// twins at run time (Topology::twin), so that a seam is not seen.
std::vector<Index> Twins(const std::vector<Index>& weld);

// Fine vertices: the cage's, then one for each polygon, then one for each edge. Seams are closed:
// copies of a vertex get the same row of positions, in which only first copies stand. An edge of one
// polygon, or of more than two, keeps its line. Texture places are left to the caller, who multiplies
// his own by attributes_from_cage.
//
// The matrix is fixed, so every face and expression of the cage is subdivided by one sparse product a frame;
// rows of positions sum to 1. Pure; `weld` has an entry for each vertex that polygons name.
face::FineMesh Subdivide(const std::vector<Polygon>& polygons, const std::vector<Index>& weld);

}  // namespace kaori::mesh
