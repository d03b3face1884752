#include "render/passes/head_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

namespace kaori::passes {
namespace {

constexpr auto kTerms = HeadFit::kTerms;
using Basis = std::array<double, kTerms>;
using Matrix = std::array<Basis, kTerms>;

// The scalp in the parameter space: all above the brows, and behind the ears all above the nape.
constexpr float kBrows = 0.63F;
constexpr float kBehindEars = 0.314F;
constexpr float kNape = 0.27F;
// What lies off the scalp by this much moves as the scalp does below it: hair keeps its thickness.
constexpr std::array<float, 3> kLayers{-0.01F, 0.005F, 0.02F};

// Spread over the scalp they say all that twenty terms can hold; the fits of all pairs of faces take time for each.
constexpr std::size_t kMostVertices = 2000;

// As hair.vert: what hangs lower moves as what is there.
constexpr float kLowest_m = -0.02F;

// Keeps a fit sane where a cast has few such vertices.
constexpr double kRidge = 1e-3;

// In the order of HeadFit::kTerms. Decimetres keep all terms near 1, and the sums of their products well
// conditioned.
Basis BasisAt(glm::vec3 p) {
  const glm::dvec3 q = glm::dvec3(p - HeadFit::kMiddle_m) * 10.0;
  const glm::dvec3 qq = q * q;
  return {1,          q.x,        q.y,        q.z,        qq.x,       qq.y,           qq.z,
          q.x * q.y,  q.y * q.z,  q.z * q.x,  qq.x * q.x, qq.x * q.y, qq.x * q.z,     qq.y * q.x,
          qq.y * q.y, qq.y * q.z, qq.z * q.x, qq.z * q.y, qq.z * q.z, q.x * q.y * q.z};
}

// Multiples of the golden ratio of the integers spread evenly, also over each row of a mesh that is numbered by rows
// (Knuth, The Art of Computer Programming, volume 3, 6.4): those below a bound are taken, about kMostVertices of them.
void Thin(std::vector<std::size_t>& scalp) {
  constexpr std::uint32_t kGolden = 0x9E3779B9;
  const std::uint64_t bound = (std::uint64_t{kMostVertices} << 32U) / scalp.size();
  std::uint32_t at = 0;
  std::erase_if(scalp, [&](std::size_t) { return (at += kGolden) >= bound; });
}

// In the parameter space u = 0.5 is the middle of the face, and v grows upwards.
std::vector<std::size_t> ScalpOf(const face::Topology& topology) {
  std::vector<std::size_t> scalp;
  for (std::size_t i = 0; i < topology.uv.size(); ++i) {
    const glm::vec2 uv = topology.uv[i];
    if (uv.y > kBrows || (std::abs(uv.x - 0.5F) > kBehindEars && uv.y > kNape)) scalp.push_back(i);
  }
  if (scalp.size() > kMostVertices) Thin(scalp);
  return scalp;
}

// A symmetric positive matrix as L of L * transpose(L), in place: Cholesky.
void Factor(Matrix& m) {
  for (std::size_t i = 0; i < kTerms; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = m[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= m[i][k] * m[j][k];
      m[i][j] = i == j ? std::sqrt(sum) : sum / m[j][j];
    }
  }
}

// Forwards with L, then backwards with its transpose; `b` becomes the solution.
void Solve(const Matrix& factor, Basis& b) {
  for (std::size_t i = 0; i < kTerms; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= factor[i][k] * b[k];
    b[i] /= factor[i][i];
  }
  for (std::size_t i = kTerms; i-- > 0;) {
    for (std::size_t k = i + 1; k < kTerms; ++k) b[i] -= factor[k][i] * b[k];
    b[i] /= factor[i][i];
  }
}

// The normal equations' left side, the same for all three axes and for each target: factored once for a face.
// Only the lower triangle is summed, since Factor reads no other part.
Matrix FactorOver(const std::vector<Basis>& bases) {
  Matrix m{};
  for (std::size_t i = 0; i < kTerms; ++i) m[i][i] = kRidge;
  for (const Basis& b : bases) {
    for (std::size_t i = 0; i < kTerms; ++i) {
      for (std::size_t j = 0; j <= i; ++j) m[i][j] += b[i] * b[j];
    }
  }
  Factor(m);
  return m;
}

// Every layer over a vertex moves as the vertex does, so that their terms are added up once (`layered`, a sum for each
// vertex). Sums are in double precision, since they run over all points of the scalp.
HeadFit::Motion MotionBetween(const std::vector<std::size_t>& scalp, const std::vector<Basis>& layered,
                              const Matrix& factor, const face::Face& from, const face::Face& to) {
  std::array<Basis, 3> sums{};
  for (std::size_t v = 0; v < scalp.size(); ++v) {
    const glm::vec3 way = to.positions[scalp[v]] - from.positions[scalp[v]];
    for (std::size_t axis = 0; axis < sums.size(); ++axis) {
      const double along = way[static_cast<int>(axis)];
      for (std::size_t i = 0; i < kTerms; ++i) sums[axis][i] += layered[v][i] * along;
    }
  }
  for (Basis& sum : sums) Solve(factor, sum);
  HeadFit::Motion motion{};
  for (std::size_t i = 0; i < kTerms; ++i) motion[i] = {sums[0][i], sums[1][i], sums[2][i], 0};
  return motion;
}

}  // namespace

HeadFit::HeadFit(const face::Cast& cast) : faces_(cast.faces.size()) {
  const std::vector<std::size_t> scalp = ScalpOf(cast.topology);
  for (const face::Face& from : cast.faces) {
    std::vector<Basis> bases, layered;
    for (const std::size_t v : scalp) {
      const glm::vec3 out = glm::normalize(from.positions[v] - kMiddle_m);
      Basis& sum = layered.emplace_back();
      for (const float off_m : kLayers) {
        const Basis& basis = bases.emplace_back(BasisAt(from.positions[v] + off_m * out));
        for (std::size_t i = 0; i < kTerms; ++i) sum[i] += basis[i];
      }
    }
    const Matrix factor = FactorOver(bases);
    for (const face::Face& to : cast.faces)
      motions_.push_back(MotionBetween(scalp, layered, factor, from, to));
  }
}

// Motions are linear in their coefficients, so that the mean motion is the mean of the coefficients.
HeadFit::Motion HeadFit::To(const face::Terms& faces, std::size_t face) const {
  Motion sum{};
  for (const face::Term& term : faces) {
    const Motion& motion = motions_[face * faces_ + term.index];
    for (std::size_t i = 0; i < kTerms; ++i) sum[i] += term.weight * motion[i];
  }
  return sum;
}

// Looks at seven points about a head: above, at both sides, behind, before, and where long hair ends. An
// estimate for the margin of what is redrawn, and no bound.
float HeadFit::Reach_m(const Motion& motion) {
  constexpr std::array<glm::vec3, 7> kAbout{{{0, 0.13F, 0},
                                             {0.1F, 0.03F, 0},
                                             {-0.1F, 0.03F, 0},
                                             {0, 0.03F, -0.11F},
                                             {0, 0.05F, 0.09F},
                                             {0.09F, -0.1F, 0},
                                             {-0.09F, -0.1F, 0}}};
  float reach_m = 0;
  for (const glm::vec3& p : kAbout) {
    const Basis basis = BasisAt({p.x, std::max(p.y, kLowest_m), p.z});
    glm::vec3 way{};
    for (std::size_t i = 0; i < kTerms; ++i) way += static_cast<float>(basis[i]) * glm::vec3(motion[i]);
    reach_m = std::max(reach_m, glm::length(way));
  }
  return reach_m;
}

}  // namespace kaori::passes
