// Fewer triangles for a face, where it is flat whatever it does.
#pragma once

#include <cstdint>
#include <vector>

#include "render/face/cast.h"

namespace kaori::mesh {

// What a triangle that replaces smaller ones may be wrong by.
struct Flatness {
  // How far a vertex that is left out stands off the chord that replaces it. A third of a pixel of a head that is as
  // high as a picture of 540 pixels.
  float height_m = 2e-4F;
  // Between the normals at both ends of an edge: light is worked out at corners, and straight between them.
  float turn_rad = 0.25F;
  // Of texture coordinates: half a texel of a skin of 1024.
  float texture = 5e-4F;
};

// The triangles of cast.topology.fine with one step of subdivision (subdivide.h) taken back wherever this face, alone,
// is flat in every expression, mouth shape and channel, each alone and at full strength, and with lids shut. An edge
// is whole on both of its sides, so nothing gapes; borders stay as they are. None where the mesh is no such
// subdivision. Takes a tenth of a second; errors there are none: the cast is without faults (face::FindFaults), and
// `face` is one of its faces.
std::vector<face::Triangle> SparseTriangles(const face::Cast& cast, std::uint16_t face,
                                            const Flatness& flatness = {});

// The same for each face of the cast, as Face::sparse.
void LeaveOutFlat(face::Cast& cast);

}  // namespace kaori::mesh
