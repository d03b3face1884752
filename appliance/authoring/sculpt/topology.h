// The topology that all faces of a cast share, from the cage and the reference face.
#pragma once

#include "appliance/authoring/sculpt/cage.h"
#include "render/face/topology.h"

namespace kaori::sculpt {

// `reference` gives the places, and the diagonals along which quads are split: the shorter one, the same on
// both sides of the face.
// Fills triangles, seams, texture coordinates and the fine mesh. Vertices that expressions can move come
// first.
face::Topology MakeTopology(const Cage& cage, const HalfShape& reference);

}  // namespace kaori::sculpt
