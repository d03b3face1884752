// The topology that all faces of a cast share, from the cage and the reference face.
#pragma once

#include "appliance/authoring/sculpt/cage.h"
#include "render/face/topology.h"

namespace kaori::sculpt {

// `reference` gives the uv, and the diagonals along which quads are split: the shorter one, the same on
// both sides of the face; a fixed diagonal would show in the flat style at the corners of the mouth. Fills
// triangles, seams, wires, texture coordinates, mouth shares, lid rings and the fine mesh. Vertices that
// expressions can move come first. Rows and lists are by the cage's vertex.
face::Topology MakeTopology(const Cage& cage, const HalfShape& reference);

}  // namespace kaori::sculpt
