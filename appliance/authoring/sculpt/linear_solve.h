// Dense linear equations, a few hundred of them.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace kaori::sculpt {

// n x n, row by row, all zero at first.
struct SquareMatrix {
  explicit SquareMatrix(std::size_t n) : size(n), value(n * n) {}
  // Not checked.
  double& operator()(std::size_t row, std::size_t column) { return value[row * size + column]; }
  double operator()(std::size_t row, std::size_t column) const { return value[row * size + column]; }

  std::size_t size;
  std::vector<double> value;
};

// Solves a * x = right for three right sides at once, in place: `right` becomes x. Gauss with row pivots,
// O(n^3). `a` is n x n and `right` has n entries. `a` is a copy, since it is used up. False where `a` is
// singular (a pivot below 1e-12); `right` is then spoilt.
bool Solve(SquareMatrix a, std::vector<glm::dvec3>& right);

// A symmetric, positive definite matrix, for many right sides: Cholesky's factor L with a = L L', which is
// made once in O(n^3).
class Factored {
 public:
  // Reads the lower triangle of `a` alone. Whether it is positive definite is for the caller to know.
  explicit Factored(SquareMatrix a);

  // As Solve above, in O(n^2).
  void Solve(std::vector<glm::dvec3>& right) const;

 private:
  SquareMatrix lower_;  // L; above its diagonal stands what was there.
};

}  // namespace kaori::sculpt
