#include "render/face/sparse.h"

#include "render/face/float4.h"

namespace kaori::face {

// A vertex is loaded as four floats, of which the last is the next vertex's first and is ignored.
void ApplyToVertices(const SparseRows& rows, const float* in, float* out) {
  const Index* column = rows.column.data();
  const float* weight = rows.weight.data();
  // Rows are written in ascending order: each overwrites the float behind its vertex, which the next row then
  // sets.
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    Float4 sum{};
    for (auto i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i) {
      sum += Load4(in + std::size_t{3} * column[i]) * weight[i];
    }
    Store4(out + 3 * row, sum);
  }
}

// Reads columns without looking: the rows were checked when the cast was (Faults::Rows).
void ApplyToValues(const SparseRows& rows, const float* in, float* out) {
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    float sum = 0;
    for (auto i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i) {
      sum += rows.weight[i] * in[rows.column[i]];
    }
    out[row] = sum;
  }
}

}  // namespace kaori::face
