// Unit normals of a surface that deforms, the same on both sides of a seam. They follow the deformed surface:
// normals that were kept from the face at rest would light a smile as if it were none.
#pragma once

#include <span>
#include <vector>

#include "render/face/aligned.h"
#include "render/face/topology.h"

namespace kaori::face {

// Lists the patches of a surface once, and then computes normals for any positions of its vertices, frame by
// frame. Borrows nothing after construction.
class SurfaceNormals {
 public:
  // `twin` as in Topology. Two triangles in a row that share an edge are one quad, and weigh as one, unless
  // the edge is among `wires`; so normals do not depend on which diagonal a quad was split along.
  SurfaceNormals(std::span<const Triangle> triangles, std::span<const Index> twin,
                 std::span<const Line> wires);

  // Each normal is the sum of the area vectors of the patches that meet at the vertex and at its twin, so
  // large patches weigh more. `positions` and `normals` are packed vertices, three floats each, with one
  // float of slack behind the last; they do not overlap. A vertex whose surface has no area gets +Z.
  // Allocates nothing; one thread at a time.
  void Compute(const float* positions, float* normals);

 private:
  using Patch = std::array<Index, 4>;  // A quad, or a triangle with its last corner twice.

  // The steps of construction: patches, then for each vertex those that meet there.
  void ListPatches(std::span<const Triangle> triangles, std::span<const Line> wires);
  void ListIncident(std::span<const Index> twin);
  // Fills areas_ from positions.
  void ComputeAreas(const float* positions);

  std::vector<Patch> patches_;
  // Per vertex, into incident_: the patches that meet there.
  std::vector<std::uint32_t> incident_start_;
  std::vector<std::uint32_t> incident_;
  // Four floats a patch: its normal, as long as its area.
  AlignedFloats areas_;
};

}  // namespace kaori::face
