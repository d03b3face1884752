// The drawn triangles: fewer, and the same surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "appliance/authoring/mesh/sparse_triangles.h"
#include "render/face/composer.h"
#include "tests/appliance/authoring/sculpt_fixture.h"

namespace kaori::tests {
namespace {

using face::Index;
using face::Triangle;

std::uint16_t Named(const auto& list, std::string_view name) {
  const auto found = std::ranges::find_if(list, [&](const auto& item) { return item.name == name; });
  EXPECT_NE(found, list.end()) << name;
  return static_cast<std::uint16_t>(found - list.begin());
}

std::vector<Triangle> SparseOf(std::string_view face, const mesh::Flatness& flatness = {}) {
  return mesh::SparseTriangles(SculptedCast(), Named(SculptedCast().faces, face), flatness);
}

// How many edges lie on one triangle alone, seams closed; -1 where one lies on more than two.
int OpenEdges(const std::vector<Triangle>& triangles, const std::vector<Index>& twin) {
  std::map<std::pair<Index, Index>, int> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = std::min(t[i], twin[t[i]]);
      const Index b = std::min(t[(i + 1) % 3], twin[t[(i + 1) % 3]]);
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  int open = 0;
  for (const auto& [edge, sides] : edges) {
    if (sides > 2) return -1;
    open += sides == 1 ? 1 : 0;
  }
  return open;
}

std::set<Index> VerticesOf(const std::vector<Triangle>& triangles) {
  std::set<Index> vertices;
  for (const Triangle& t : triangles) vertices.insert(t.begin(), t.end());
  return vertices;
}

// Of a point to a triangle; Ericson: Real-Time Collision Detection, 5.1.5, by barycentric coordinates that are kept
// within the triangle, which gives a little too much beyond its corners.
float Distance(glm::vec3 p, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  const glm::vec3 ab = b - a, ac = c - a, ap = p - a;
  const float d00 = glm::dot(ab, ab), d01 = glm::dot(ab, ac), d11 = glm::dot(ac, ac);
  const float d20 = glm::dot(ap, ab), d21 = glm::dot(ap, ac);
  const float area = std::max(d00 * d11 - d01 * d01, 1e-20F);
  const float v = glm::clamp((d11 * d20 - d01 * d21) / area, 0.0F, 1.0F);
  const float w = glm::clamp((d00 * d21 - d01 * d20) / area, 0.0F, 1.0F - v);
  return glm::distance(p, a + ab * v + ac * w);
}

TEST(SparseTriangles, AreFewerAndNothingGapes) {
  const face::Cast& cast = SculptedCast();
  const face::FineMesh& fine = cast.topology.fine;
  for (const face::Face& face : cast.faces) {
    const auto sparse = SparseOf(face.name);
    EXPECT_LT(sparse.size(), fine.triangles.size() * 3 / 4) << face.name;
    EXPECT_GT(sparse.size(), cast.topology.triangles.size()) << face.name;
    EXPECT_EQ(OpenEdges(sparse, fine.twin), OpenEdges(fine.triangles, fine.twin)) << face.name;
    RecordProperty("triangles_of_" + face.name, static_cast<int>(sparse.size()));
  }
}

TEST(SparseTriangles, StayOnTheSurfaceInExpressionsThatBendItMost) {
  const face::Cast& cast = SculptedCast();
  face::Composer composer(cast);
  const auto all = VerticesOf(cast.topology.fine.triangles);
  for (const std::string_view face : {"kaori", "kettle"}) {
    const auto sparse = SparseOf(face);
    std::vector<Index> left_out;
    std::ranges::set_difference(all, VerticesOf(sparse), std::back_inserter(left_out));
    ASSERT_GT(left_out.size(), 500U);
    face::Weights pose;
    pose.faces.Push(Named(cast.faces, face), 1);
    pose.expressions.Push(Named(cast.expressions, "laugh"), 1);
    const face::Shape& shape = composer.Compose(pose, face::Detail::kFine);
    float farthest_m = 0;
    for (std::size_t i = 0; i < left_out.size(); i += 7) {
      float nearest_m = std::numeric_limits<float>::max();
      for (const Triangle& t : sparse)
        nearest_m = std::min(nearest_m, Distance(shape.fine[left_out[i]], shape.fine[t[0]], shape.fine[t[1]],
                                                 shape.fine[t[2]]));
      farthest_m = std::max(farthest_m, nearest_m);
    }
    EXPECT_LE(farthest_m, 1.5F * mesh::Flatness{}.height_m) << face;
    EXPECT_GT(farthest_m, 0) << face;
  }
}

TEST(SparseTriangles, FaceOutwardsAsThoseThatTheyReplace) {
  const face::Cast& cast = SculptedCast();
  face::Composer composer(cast);
  const face::Shape& shape = composer.Compose({}, face::Detail::kFine);
  for (const Triangle& t : SparseOf(cast.faces.front().name)) {
    const glm::vec3 area =
        glm::cross(shape.fine[t[1]] - shape.fine[t[0]], shape.fine[t[2]] - shape.fine[t[0]]);
    EXPECT_GT(glm::length(area), 0);
  }
}

// The control: where nothing may be wrong, nothing is left out.
TEST(SparseTriangles, AreAllOfThemWhereNothingCountsAsFlat) {
  const mesh::Flatness none{.height_m = -1, .turn_rad = -1, .texture = -1};
  EXPECT_EQ(SparseOf("kaori", none).size(), SculptedCast().topology.fine.triangles.size());
}

TEST(SparseTriangles, AreNoneOfAMeshThatWasNotSubdivided) {
  face::Cast cast = SculptedCast();
  cast.topology.fine.triangles.erase(cast.topology.fine.triangles.begin());
  EXPECT_TRUE(mesh::SparseTriangles(cast, 0).empty());
}

}  // namespace
}  // namespace kaori::tests
