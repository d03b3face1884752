// The fine mesh of imported heads.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "appliance/authoring/import/fine_mesh.h"
#include "appliance/authoring/import/mesh_graph.h"

namespace kaori::import {
namespace {

// A cube of quads, each two triangles in a row.
std::vector<glm::vec3> CubeCorners() {
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  return corners;
}

std::vector<Triangle> CubeTriangles() {
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c, d] : std::vector<std::array<Index, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  return triangles;
}

glm::vec3 At(const face::SparseRows& rows, std::size_t row, const std::vector<glm::vec3>& cage) {
  glm::vec3 at{};
  for (std::uint32_t i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i)
    at += rows.weight[i] * cage[rows.column[i]];
  return at;
}

TEST(FineMesh, FindsTheQuadsThatTheArtistDrew) {
  const auto polygons = PolygonsOf(CubeTriangles());
  ASSERT_EQ(polygons.size(), 6U);
  EXPECT_EQ(polygons[0], (mesh::Polygon{3, 1, 0, 2}));
}

TEST(FineMesh, KeepsATriangleThatHasNoPartner) {
  const auto polygons = PolygonsOf({{0, 1, 2}, {5, 6, 7}});
  ASSERT_EQ(polygons.size(), 2U);
  EXPECT_EQ(polygons[0].size(), 3U);
}

TEST(FineMesh, MakesARoundThingOfACube) {
  const auto corners = CubeCorners();
  const std::vector<glm::vec2> uv(corners.size());
  const face::FineMesh fine = MakeFineMesh(CubeTriangles(), Weld(corners), uv);
  ASSERT_EQ(fine.from_cage.rows(), 8U + 6U + 12U);
  EXPECT_EQ(fine.triangles.size(), 48U);
  // Catmull and Clark's rule on a cube: corners come to 5/9, edges to 3/4, middles stay.
  EXPECT_NEAR(glm::length(At(fine.from_cage, 0, corners)), std::sqrt(3.0F) * 5 / 9, 1e-5);
  EXPECT_NEAR(glm::length(At(fine.from_cage, 8, corners)), 1, 1e-5);
  EXPECT_NEAR(glm::length(At(fine.from_cage, 14, corners)), std::sqrt(2.0F) * 0.75F, 1e-5);
}

TEST(FineMesh, TurnsEveryTriangleOutwards) {
  const auto corners = CubeCorners();
  const face::FineMesh fine = MakeFineMesh(CubeTriangles(), Weld(corners), std::vector<glm::vec2>(8));
  for (const Triangle& t : fine.triangles) {
    const glm::vec3 a = At(fine.from_cage, t[0], corners);
    const glm::vec3 b = At(fine.from_cage, t[1], corners);
    const glm::vec3 c = At(fine.from_cage, t[2], corners);
    EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a + b + c), 0);
  }
}

// Two quads side by side, the vertices between them doubled as at a seam of the texture.
TEST(FineMesh, ClosesSeamsOfTheTexture) {
  const std::vector<glm::vec3> places{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                      {1, 0, 0}, {2, 0, 1}, {2, 1, 1}, {1, 1, 0}};
  const std::vector<glm::vec2> uv{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const face::FineMesh fine = MakeFineMesh({{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}, Weld(places), uv);
  EXPECT_EQ(fine.twin[1], 4U);
  EXPECT_EQ(fine.twin[4], 1U);
  EXPECT_EQ(fine.twin[0], 0U);
  EXPECT_EQ(At(fine.from_cage, 1, places), At(fine.from_cage, 4, places));
  EXPECT_EQ(fine.texture[1], glm::vec2(1, 0));
  EXPECT_EQ(fine.texture[4], glm::vec2(0, 0));
  int seam_twins = 0;
  for (std::size_t v = 0; v < fine.twin.size(); ++v) seam_twins += fine.twin[v] != v ? 1 : 0;
  EXPECT_EQ(seam_twins, 6);  // Two pairs of corners, one of an edge's middle.
}

}  // namespace
}  // namespace kaori::import
