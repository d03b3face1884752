// The small mathematics under the sculptor.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/delaunay.h"
#include "appliance/authoring/sculpt/disc.h"
#include "appliance/authoring/sculpt/linear_solve.h"
#include "appliance/authoring/sculpt/pchip.h"
#include "appliance/authoring/sculpt/signed_distance.h"
#include "appliance/authoring/sculpt/warp.h"

namespace kaori::sculpt {
namespace {

TEST(Pchip, PassesThroughItsNumbersAndNeverOvershoots) {
  const Pchip curve({0, 1, 2, 5}, {0, 1, 1, 4});
  EXPECT_DOUBLE_EQ(curve.At(1), 1);
  EXPECT_DOUBLE_EQ(curve.At(5), 4);
  for (double x = 1; x <= 2; x += 0.1) EXPECT_DOUBLE_EQ(curve.At(x), 1);
  for (double x = 0; x <= 5; x += 0.1) EXPECT_TRUE(curve.At(x) >= 0 && curve.At(x) <= 4);
}

TEST(Pchip, OfAStraightLineIsTheLine) {
  const Pchip curve({0, 3, 4}, {1, 7, 9});
  for (double x = 0; x <= 4; x += 0.25) EXPECT_NEAR(curve.At(x), 1 + 2 * x, 1e-12);
}

TEST(LinearSolve, FindsWhatWasPutIn) {
  SquareMatrix a(3);
  a.value = {0, 2, 1, 1, 0, -1, 3, 1, 2};  // The first pivot is zero.
  std::vector<glm::dvec3> right{{7, 0, 2}, {-2, 1, 0}, {11, 3, 1}};
  ASSERT_TRUE(Solve(a, right));
  EXPECT_LT(glm::distance(2.0 * right[1] + right[2], glm::dvec3(7, 0, 2)), 1e-12);
  EXPECT_LT(glm::distance(right[0] - right[2], glm::dvec3(-2, 1, 0)), 1e-12);
}

// Hilbert's matrix with something on its diagonal: symmetric, positive definite and far from diagonal.
TEST(LinearSolve, FindsTheSameByCholeskysFactorAsByElimination) {
  constexpr std::size_t kSize = 40;
  SquareMatrix a(kSize);
  std::vector<glm::dvec3> right;
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j < kSize; ++j)
      a(i, j) = 1 / static_cast<double>(i + j + 1) + (i == j ? 1e-3 : 0);
    right.emplace_back(static_cast<double>(i), 1, i == 7 ? 1 : 0);
  }
  std::vector<glm::dvec3> eliminated = right;
  ASSERT_TRUE(Solve(a, eliminated));
  const Factored factored(a);
  for (int n = 0; n < 2; ++n) {
    std::vector<glm::dvec3> found = right;
    factored.Solve(found);
    for (std::size_t i = 0; i < kSize; ++i)
      EXPECT_LT(glm::distance(found[i], eliminated[i]), 1e-8 * (1 + glm::length(eliminated[i]))) << i;
  }
}

TEST(LinearSolve, RefusesASingularMatrix) {
  SquareMatrix a(2);
  a.value = {1, 2, 2, 4};
  std::vector<glm::dvec3> right(2);
  EXPECT_FALSE(Solve(a, right));
}

TEST(Warp, TakesEachPullExactlyAndCarriesWhatIsAffine) {
  const std::vector<Pull> pulls{{{0, 0, 0}, {1, 0, 0}},
                                {{1, 0, 0}, {3, 0, 0}},
                                {{0, 1, 0}, {1, 2, 0}},
                                {{0, 0, 1}, {1, 0, 2}},
                                {{1, 1, 1}, {3, 2, 2}}};
  const auto warp = Warp::Through(pulls);
  ASSERT_TRUE(warp);
  for (const Pull& pull : pulls) EXPECT_LT(glm::distance((*warp)(pull.from), pull.to), 1e-9);
  EXPECT_LT(glm::distance((*warp)({0.3, 0.4, 0.2}), {1.6, 0.8, 0.4}), 1e-9);
}

TEST(Warp, RefusesTwoPullsFromOnePoint) {
  EXPECT_FALSE(Warp::Through({{{0, 0, 0}, {1, 0, 0}},
                              {{0, 0, 0}, {2, 0, 0}},
                              {{0, 1, 0}, {0, 1, 0}},
                              {{0, 0, 1}, {0, 0, 1}},
                              {{1, 0, 0}, {1, 0, 0}}}));
}

TEST(SignedDistance, OfASphereIsExact) {
  const std::vector<Body> sphere{{.a = {1, 2, 3}, .b = {2, 2, 2}}};
  EXPECT_NEAR(SignedDistance(sphere, {5, 2, 3}), 2, 1e-12);
  EXPECT_NEAR(SignedDistance(sphere, {1, 3, 3}), -1, 1e-12);
}

TEST(SignedDistance, CutsAndBlends) {
  Body hollow{.join = Body::Join::kCut, .a = {0, 0, 2}, .b = {1, 1, 1}};
  const std::vector<Body> bodies{{.a = {0, 0, 0}, .b = {2, 2, 2}}, hollow};
  EXPECT_GT(SignedDistance(bodies, {0, 0, 1.5}), 0);
  EXPECT_LT(SignedDistance(bodies, {0, 0, -1.5}), 0);
}

TEST(Project, HitsTheFirstSurfaceFromOutside) {
  const std::vector<Body> bodies{{.a = {0, 0, 0}, .b = {2, 2, 2}}, {.a = {0, 0, 5}, .b = {1, 1, 1}}};
  EXPECT_NEAR(Project(bodies, {0, 0, 4}, {0, 0, 1}).z, 6, 1e-6);
}

TEST(Delaunay, HasNoPointInsideAnyCircle) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 40; ++i) points.emplace_back(std::fmod(i * 7.31, 10), std::fmod(i * 3.77, 10));
  const auto triangles = Delaunay(points);
  ASSERT_GT(triangles.size(), 40U);
  for (const Corners3& t : triangles) {
    const glm::dvec2 a = points[t[0]], b = points[t[1]] - a, c = points[t[2]] - a;
    const double d = 2 * (b.x * c.y - b.y * c.x);
    ASSERT_GT(d, 0);
    const glm::dvec2 centre(c.y * glm::dot(b, b) - b.y * glm::dot(c, c),
                            b.x * glm::dot(c, c) - c.x * glm::dot(b, b));
    const double radius = glm::length(centre / d);
    for (const glm::dvec2& p : points) EXPECT_GE(glm::distance(p, a + centre / d), radius - 1e-9);
  }
}

TEST(Delaunay, OfALineIsEmpty) {
  EXPECT_TRUE(Delaunay({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).empty());
}

TEST(Disc, TakesTheBorderOfTheSquareToTheCircle) {
  for (double t = -1; t <= 1; t += 0.25) {
    EXPECT_NEAR(glm::length(DiscFromSquare({1, t})), 1, 1e-12);
    EXPECT_NEAR(glm::length(DiscFromSquare({t, -1})), 1, 1e-12);
  }
}

TEST(SignedDistance, OfABoxWithRoundedEdgesIsThatToItsNearestPoint) {
  const Body box{.shape = Body::Shape::kBox, .a = {1, 0, 0}, .b = {2, 1, 3}, .radius_a_cm = 0.5};
  EXPECT_NEAR(SignedDistance({box}, {5, 0, 0}), 2, 1e-12) << "from its side";
  EXPECT_NEAR(SignedDistance({box}, {1, 0, 0}), -1, 1e-12) << "in its middle";
  EXPECT_NEAR(SignedDistance({box}, {2.5 + 3, 0.5 + 4, 0}), 4.5, 1e-12) << "from its round edge";
}

}  // namespace
}  // namespace kaori::sculpt
