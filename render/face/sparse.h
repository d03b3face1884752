// Applies a fixed sparse matrix to the vertices of a mesh, or to one number of each. Pure; nothing allocates.
// Columns are not checked here: FindFaults has done so.
#pragma once

#include "render/face/topology.h"

namespace kaori::face {

// out[row] = sum of weight * in[column], three packed floats each. Both arrays have one float of slack behind
// the last vertex; `out` is no part of `in`.
void ApplyToVertices(const SparseRows& rows, const float* in, float* out);

// The same for one float of each vertex; no slack is needed.
void ApplyToValues(const SparseRows& rows, const float* in, float* out);

}  // namespace kaori::face
