// Normals of the deformed surface.
#include "render/face/normals.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "render/face/composer.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {
namespace {

using face::AlignedFloats;
using face::SurfaceNormals;
using face::Triangle;

std::vector<glm::vec3> Compute(SurfaceNormals& surface, std::vector<glm::vec3> positions) {
  AlignedFloats in(3 * positions.size());
  AlignedFloats out(3 * positions.size());
  std::ranges::copy(positions, in.vertices(positions.size()).begin());
  surface.Compute(in.data(), out.data());
  const auto normals = out.vertices(positions.size());
  return {normals.begin(), normals.end()};
}

const std::vector<glm::vec3> kFourCorners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.4F}, {0, 1, 0}};

TEST(Normals, PointOutOfACounterClockwiseTriangle) {
  SurfaceNormals surface(std::vector<Triangle>{{0, 1, 2}}, std::vector<face::Index>{0, 1, 2}, {});
  for (const glm::vec3& n : Compute(surface, {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}))
    EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

TEST(Normals, DoNotDependOnTheDiagonalOfAQuad) {
  const std::vector<face::Index> twin{0, 1, 2, 3};
  SurfaceNormals one(std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}, twin, {});
  SurfaceNormals other(std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}, twin, {});
  const auto a = Compute(one, kFourCorners);
  const auto b = Compute(other, kFourCorners);
  for (std::size_t v = 0; v < a.size(); ++v) EXPECT_LT(glm::distance(a[v], b[v]), 1e-6F);
}

TEST(Normals, KeepTrianglesApartAlongAWire) {
  const std::vector<face::Line> wires{{2, 0}};
  SurfaceNormals surface(std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}, std::vector<face::Index>{0, 1, 2, 3},
                         wires);
  const auto normals = Compute(surface, kFourCorners);
  EXPECT_LT(glm::distance(normals[1], glm::normalize(glm::cross(kFourCorners[1], kFourCorners[2]))), 1e-6F);
  EXPECT_LT(glm::distance(normals[3], glm::normalize(glm::cross(kFourCorners[2], kFourCorners[3]))), 1e-6F);
}

TEST(Normals, AreUpwardsWhereTheSurfaceHasNoArea) {
  SurfaceNormals surface(std::vector<Triangle>{{0, 1, 2}}, std::vector<face::Index>{0, 1, 2}, {});
  for (const glm::vec3& n : Compute(surface, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}))
    EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

// Sums of triangle normals, the long way round.
std::vector<glm::vec3> ByTriangles(const std::vector<Triangle>& triangles,
                                   const std::vector<face::Index>& twin,
                                   std::span<const glm::vec3> positions) {
  std::vector<glm::vec3> sums(positions.size());
  for (const Triangle& t : triangles) {
    const glm::vec3 area = glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
    for (const face::Index v : t) sums[v] += area;
  }
  std::vector<glm::vec3> normals(positions.size());
  for (std::size_t v = 0; v < sums.size(); ++v) {
    normals[v] = glm::normalize(twin[v] == v ? sums[v] : sums[v] + sums[twin[v]]);
  }
  return normals;
}

TEST(Normals, AreUnitAndFollowTheDeformedSurface) {
  const face::Cast cast = MakeSyntheticCast();
  face::Composer composer(cast);
  face::Weights w;
  w.faces.Push(3, 1);
  w.expressions.Push(ExpressionNamed(cast, "surprised"), 1);
  const auto& shape = composer.Compose(w, face::Detail::kFine);
  const auto& fine = cast.topology.fine;
  const auto wanted = ByTriangles(fine.triangles, fine.twin, shape.fine);
  double sum = 0;
  for (std::size_t v = 0; v < wanted.size(); ++v) {
    ASSERT_NEAR(glm::length(shape.fine_normals[v]), 1, 1e-5);
    sum += static_cast<double>(glm::dot(wanted[v], shape.fine_normals[v]));
  }
  EXPECT_GT(sum / static_cast<double>(wanted.size()),
            0.995);  // Quads weigh a little differently than triangles.
}

TEST(Normals, AreEqualOnBothSidesOfTheSeam) {
  const face::Cast cast = MakeSyntheticCast();
  face::Composer composer(cast);
  const auto& shape = composer.Compose({}, face::Detail::kFine);
  int seam = 0;
  for (std::size_t v = 0; v < shape.fine.size(); ++v) {
    const face::Index twin = cast.topology.fine.twin[v];
    if (twin == v) continue;
    ++seam;
    ASSERT_EQ(shape.fine_normals[v], shape.fine_normals[twin]);
  }
  EXPECT_GT(seam, 20);
}

}  // namespace
}  // namespace kaori::tests
