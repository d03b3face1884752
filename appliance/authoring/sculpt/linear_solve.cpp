#include "appliance/authoring/sculpt/linear_solve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kaori::sculpt {
namespace {

// Of a pivot, in the unit of the matrix: for warps in centimetres entries are distances of about 1 to 30.
// Below it rows depend on each other.
constexpr double kSingular = 1e-12;

// The row at or below `column` whose entry there is largest: partial pivoting keeps the factors below 1.
std::size_t PivotRow(SquareMatrix& a, std::size_t column) {
  std::size_t best = column;
  for (std::size_t row = column + 1; row < a.size; ++row) {
    if (std::abs(a(row, column)) > std::abs(a(best, column))) best = row;
  }
  return best;
}

void SwapRows(SquareMatrix& a, std::vector<glm::dvec3>& right, std::size_t i, std::size_t j) {
  if (i == j) return;
  for (std::size_t column = 0; column < a.size; ++column) std::swap(a(i, column), a(j, column));
  std::swap(right[i], right[j]);
}

// Rows that have a zero there already are left alone.
void ClearBelow(SquareMatrix& a, std::vector<glm::dvec3>& right, std::size_t pivot) {
  for (std::size_t row = pivot + 1; row < a.size; ++row) {
    const double factor = a(row, pivot) / a(pivot, pivot);
    if (factor == 0) continue;
    for (std::size_t column = pivot; column < a.size; ++column) a(row, column) -= factor * a(pivot, column);
    right[row] -= factor * right[pivot];
  }
}

// From the last row upwards.
void SubstituteBack(SquareMatrix& a, std::vector<glm::dvec3>& right) {
  for (std::size_t row = a.size; row-- > 0;) {
    for (std::size_t column = row + 1; column < a.size; ++column)
      right[row] -= a(row, column) * right[column];
    right[row] /= a(row, row);
  }
}

}  // namespace

// Once for each warp, whose unknowns are its landmarks and four; and, for an import, n / 3 times for the
// inverse of the normal matrix of n control points.
bool Solve(SquareMatrix a, std::vector<glm::dvec3>& right) {
  for (std::size_t pivot = 0; pivot < a.size; ++pivot) {
    SwapRows(a, right, pivot, PivotRow(a, pivot));
    if (std::abs(a(pivot, pivot)) < kSingular) return false;
    ClearBelow(a, right, pivot);
  }
  SubstituteBack(a, right);
  return true;
}

}  // namespace kaori::sculpt
