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

// Once for each warp, whose unknowns are its landmarks and four.
bool Solve(SquareMatrix a, std::vector<glm::dvec3>& right) {
  for (std::size_t pivot = 0; pivot < a.size; ++pivot) {
    SwapRows(a, right, pivot, PivotRow(a, pivot));
    if (std::abs(a(pivot, pivot)) < kSingular) return false;
    ClearBelow(a, right, pivot);
  }
  SubstituteBack(a, right);
  return true;
}

// Row by row, in place: both factors of each product lie in a row one behind the other.
Factored::Factored(SquareMatrix a) : lower_(std::move(a)) {
  for (std::size_t i = 0; i < lower_.size; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = lower_(i, j);
      for (std::size_t k = 0; k < j; ++k) rest -= lower_(i, k) * lower_(j, k);
      lower_(i, j) = i == j ? std::sqrt(rest) : rest / lower_(j, j);
    }
  }
}

// L y = right downwards, then L' x = y upwards, for which L is read by rows as well: once x_i is known its
// part is taken out of all above it.
void Factored::Solve(std::vector<glm::dvec3>& right) const {
  for (std::size_t i = 0; i < lower_.size; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i] -= lower_(i, k) * right[k];
    right[i] /= lower_(i, i);
  }
  for (std::size_t i = lower_.size; i-- > 0;) {
    right[i] /= lower_(i, i);
    for (std::size_t k = 0; k < i; ++k) right[k] -= lower_(i, k) * right[i];
  }
}

}  // namespace kaori::sculpt
