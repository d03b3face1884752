// The topology that the sculptor makes: closed, split alike on both sides, with a texture that favours the
// face.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/paint_attributes.h"
#include "appliance/authoring/sculpt/texture_map.h"
#include "tests/appliance/authoring/sculpt_fixture.h"

namespace kaori::tests {
namespace {

using face::Index;
using face::Topology;
using sculpt::Cage;
using sculpt::Region;

const Topology& TheTopology() {
  return SculptedCast().topology;
}

// How many triangles lie on each edge, seams closed.
template <class Triangles>
std::map<std::pair<Index, Index>, int> Edges(const Triangles& triangles, const std::vector<Index>& twin) {
  std::map<std::pair<Index, Index>, int> edges;
  for (const face::Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = std::min(t[i], twin[t[i]]);
      const Index b = std::min(t[(i + 1) % 3], twin[t[(i + 1) % 3]]);
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  return edges;
}

template <class Map>
long CountEdges(const Map& edges, int faces) {
  return std::count_if(edges.begin(), edges.end(),
                       [faces](const auto& edge) { return edge.second == faces; });
}

TEST(SculptedTopology, HasTheVerticesAndTrianglesOfTheRecipe) {
  EXPECT_EQ(TheTopology().vertex_count, 2807U);
  EXPECT_EQ(TheTopology().triangles.size(), 5386U);
  EXPECT_EQ(TheTopology().fine.from_cage.rows(), 11007U);
  EXPECT_EQ(TheTopology().fine.triangles.size(), 21556U);
}

// The neck ends in an open loop of 52 edges, each eye's socket in one of 28.
TEST(SculptedTopology, IsClosedButForNeckAndEyeSockets) {
  const auto edges = Edges(TheTopology().triangles, TheTopology().twin);
  EXPECT_EQ(CountEdges(edges, 1), 52 + 2 * 28);
  EXPECT_EQ(CountEdges(edges, 1) + CountEdges(edges, 2), static_cast<long>(edges.size()));
  const auto fine = Edges(TheTopology().fine.triangles, TheTopology().fine.twin);
  EXPECT_EQ(CountEdges(fine, 1), 2 * (52 + 2 * 28));
  EXPECT_EQ(CountEdges(fine, 1) + CountEdges(fine, 2), static_cast<long>(fine.size()));
}

TEST(SculptedTopology, SplitsQuadsTheSameOnBothSides) {
  const Cage cage = sculpt::BuildCage();
  std::set<std::set<Index>> triangles;
  for (const face::Triangle& t : TheTopology().triangles) triangles.insert({t[0], t[1], t[2]});
  const auto mirrored = [&cage](Index v) {
    const sculpt::CageVertex& vertex = cage.vertices[v];
    return vertex.side > 0 ? cage.right[vertex.half] : cage.left[vertex.half];
  };
  for (const face::Triangle& t : TheTopology().triangles) {
    EXPECT_TRUE(triangles.contains({mirrored(t[0]), mirrored(t[1]), mirrored(t[2])}));
  }
}

TEST(SculptedTopology, DrawsEachQuadEdgeOnceAndNoDiagonal) {
  const Cage cage = sculpt::BuildCage();
  std::set<std::pair<Index, Index>> wires;
  for (const face::Line& wire : TheTopology().wires) {
    EXPECT_TRUE(wires.emplace(wire[0], wire[1]).second);
  }
  const auto edges = Edges(TheTopology().triangles, TheTopology().twin);
  const auto triangles = static_cast<long>(TheTopology().triangles.size());
  const long diagonals = triangles - static_cast<long>(cage.quads.size());
  EXPECT_EQ(static_cast<long>(wires.size()), static_cast<long>(edges.size()) - diagonals);
}

TEST(SculptedTopology, SharesPositionsAcrossSeamsInEveryFace) {
  for (const face::Face& f : SculptedCast().faces) {
    for (Index v = 0; v < TheTopology().vertex_count; ++v) {
      EXPECT_EQ(f.positions[v], f.positions[TheTopology().twin[v]]) << f.name << " " << v;
    }
  }
}

TEST(SculptedTopology, GivesTheLipsAllAndTheBrowsNothingOfTheMouth) {
  const Cage cage = sculpt::BuildCage();
  const auto share = [&cage](Region region, int a, int b) {
    return TheTopology().mouth_share[cage.left[cage.half.At(region, a, b)]];
  };
  EXPECT_EQ(share(Region::kMouth, 8, 6), 1);
  EXPECT_EQ(share(Region::kGrid, 0, 9), 1);
  EXPECT_EQ(share(Region::kGrid, 5, 26), 0);
  EXPECT_EQ(share(Region::kEye, 21, 5), 0);
  EXPECT_GT(share(Region::kGrid, 6, 15), 0);
  EXPECT_LT(share(Region::kGrid, 6, 15), 1);
}

TEST(SculptedTopology, LidRigsMeetInTheCorners) {
  for (const face::LidRig& rig : TheTopology().lids) {
    for (int k = 0; k < rig.rings; ++k) {
      const auto inner = static_cast<std::size_t>(k) * static_cast<std::size_t>(rig.columns);
      const auto outer = inner + static_cast<std::size_t>(rig.columns - 1);
      EXPECT_EQ(rig.upper[inner], rig.lower[inner]);
      EXPECT_EQ(rig.upper[outer], rig.lower[outer]);
    }
    EXPECT_EQ(rig.follow_upper[static_cast<std::size_t>(rig.margin_ring)], 1);
  }
}

TEST(FineMesh, IsAMeanOfTheCage) {
  for (const face::SparseRows* rows :
       {&TheTopology().fine.from_cage, &TheTopology().fine.attributes_from_cage}) {
    for (std::size_t row = 0; row < rows->rows(); ++row) {
      float sum = 0;
      for (auto i = rows->row_start[row]; i < rows->row_start[row + 1]; ++i) sum += rows->weight[i];
      ASSERT_NEAR(sum, 1, 1e-5) << row;
    }
  }
}

TEST(FineMesh, SharesPositionsAcrossSeams) {
  const face::FineMesh& fine = TheTopology().fine;
  const auto position = [&fine](Index row) {
    glm::vec3 p{};
    for (auto i = fine.from_cage.row_start[row]; i < fine.from_cage.row_start[row + 1]; ++i) {
      p += fine.from_cage.weight[i] * SculptedCast().faces[0].positions[fine.from_cage.column[i]];
    }
    return p;
  };
  int twins = 0;
  for (Index v = 0; v < fine.twin.size(); ++v) {
    if (fine.twin[v] == v) continue;
    ++twins;
    EXPECT_LT(glm::distance(position(v), position(fine.twin[v])), 1e-6F);
  }
  EXPECT_GT(twins, 200);
}

TEST(TextureMap, IsItsOwnInverse) {
  for (double u = -21; u <= 21; u += 0.37) {
    for (double v = -17.5; v <= 13.5; v += 0.41) {
      const glm::dvec2 uv_cm(u, v);
      const glm::dvec2 texture = sculpt::TextureFromUv(uv_cm);
      EXPECT_LT(glm::distance(sculpt::UvFromTexture(texture), uv_cm), 1e-9);
      EXPECT_TRUE(texture.x >= 0 && texture.x <= 1 && texture.y >= 0 && texture.y <= 1);
    }
  }
}

TEST(TextureMap, GivesTheFaceMostOfThePicture) {
  const glm::dvec2 low = sculpt::TextureFromUv({-6.9, -10.2});
  const glm::dvec2 high = sculpt::TextureFromUv({6.9, 4.9});
  EXPECT_GT(high.x - low.x, 0.6);
  EXPECT_GT(high.y - low.y, 0.69);
}

TEST(PaintAttributes, KnowLipsLidsBagAndEar) {
  const Cage cage = sculpt::BuildCage();
  const std::vector<sculpt::PaintAttributes> paint = sculpt::PaintAttributesOf(cage);
  ASSERT_EQ(paint.size(), TheTopology().vertex_count);
  const auto at = [&](Region region, int a, int b) { return paint[cage.right[cage.half.At(region, a, b)]]; };
  EXPECT_EQ(at(Region::kEye, 7, 5).eye_ring, 5);
  EXPECT_EQ(at(Region::kEye, 21, 5).eye_ring, -5);
  EXPECT_EQ(at(Region::kMouth, 2, 3).mouth_ring, 3);
  EXPECT_EQ(at(Region::kMouth, 14, 9).mouth_ring, -6);
  EXPECT_EQ(at(Region::kMouth, 14, 9).bag, 1);
  EXPECT_EQ(at(Region::kMouth, 14, 6).bag, 0);
  EXPECT_EQ(at(Region::kEar, 3, 5).ear_ring, 1);
  EXPECT_EQ(at(Region::kGrid, 0, 17).spout, 1);
  EXPECT_EQ(at(Region::kGrid, 5, 26).mouth_ring, 0);
}

}  // namespace
}  // namespace kaori::tests
