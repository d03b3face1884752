#include "appliance/authoring/sculpt/warp.h"

#include <utility>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/linear_solve.h"

namespace kaori::sculpt {
namespace {

constexpr std::size_t kAffine = 4;

// 1, x, y, z.
double AffineTerm(glm::dvec3 p, std::size_t term) {
  return term == 0 ? 1 : p[static_cast<int>(term) - 1];
}

}  // namespace

// The displacement at p is sum_i w_i |p - p_i| + a_0 + a_1 x + a_2 y + a_3 z. The kernel r is the fundamental
// solution of the biharmonic equation in three dimensions, as r^2 log r is in two (the thin plate spline):
// among all interpolants it bends least. The last four rows of the matrix ask that the weights sum to zero,
// alone and times x, y and z, so that what is affine is carried by the affine part.
std::optional<Warp> Warp::Through(std::vector<Pull> pulls) {
  const std::size_t n = pulls.size();
  SquareMatrix a(n + kAffine);
  std::vector<glm::dvec3> weight(n + kAffine, glm::dvec3(0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) a(i, j) = glm::distance(pulls[i].from, pulls[j].from);
    for (std::size_t k = 0; k < kAffine; ++k) a(i, n + k) = a(n + k, i) = AffineTerm(pulls[i].from, k);
    weight[i] = pulls[i].to - pulls[i].from;
  }
  if (!Solve(std::move(a), weight)) return std::nullopt;
  Warp warp;
  warp.pulls_ = std::move(pulls);
  warp.weight_ = std::move(weight);
  return warp;
}

// The sum is a displacement, so a warp without weights leaves every point.
glm::dvec3 Warp::operator()(glm::dvec3 p) const {
  glm::dvec3 q = p;
  for (std::size_t i = 0; i < pulls_.size(); ++i) q += weight_[i] * glm::distance(p, pulls_[i].from);
  for (std::size_t k = 0; k < kAffine; ++k) q += weight_[pulls_.size() + k] * AffineTerm(p, k);
  return q;
}

}  // namespace kaori::sculpt
