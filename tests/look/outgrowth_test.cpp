// Half-way between ears and a handle: neither horns nor antlers.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

#include "render/face/composer.h"
#include "tests/look/look_pack.h"
#include "tests/look/report.h"

namespace kaori {
namespace {

constexpr float kLowBump_m = 0.03F;

std::uint16_t FaceNamed(const face::Cast& cast, std::string_view name) {
  const auto found = std::ranges::find(cast.faces, name, &face::Face::name);
  return static_cast<std::uint16_t>(found - cast.faces.begin());
}

// Of the parameter space, from its lower border: ears lie above this, the neck below.
constexpr float kNeckBelow = 0.3F;

// How far ears stand off the head between two faces: the farthest of their vertices from the nearest vertex of
// all others.
float StandsOff_m(face::Composer& composer, const face::Topology& topology, std::uint16_t a, std::uint16_t b,
                  float share_of_b) {
  face::Weights weights;
  weights.faces.Push(a, 1 - share_of_b);
  weights.faces.Push(b, share_of_b);
  weights.expressions.Push(0, 1);
  const auto cage = composer.Compose(weights, face::Detail::kCage).cage;
  std::vector<bool> grows(cage.size());
  for (const face::Index v : topology.outgrowth) grows[v] = true;
  float farthest_m = 0;
  for (const face::Index v : topology.outgrowth) {
    if (topology.uv[v].y < kNeckBelow) continue;
    float nearest_m = 1;
    for (std::size_t w = 0; w < cage.size(); ++w) {
      if (!grows[w]) nearest_m = std::min(nearest_m, glm::distance(cage[v], cage[w]));
    }
    farthest_m = std::max(farthest_m, nearest_m);
  }
  return farthest_m;
}

TEST(Outgrowths, AreWithdrawnBetweenAHeadWithEarsAndOneWithAHandle) {
  const face::Cast cast = tests::ClothedCast();
  face::Composer composer(cast);
  const std::uint16_t kettle = FaceNamed(cast, "kettle");
  ASSERT_LT(kettle, cast.faces.size());
  float farthest_m = 0;
  for (std::uint16_t face = 0; face < cast.faces.size(); ++face) {
    if (face == kettle) continue;
    for (const float share : {0.3F, 0.5F, 0.7F})
      farthest_m = std::max(farthest_m, StandsOff_m(composer, cast.topology, face, kettle, share));
  }
  EXPECT_LE(farthest_m, kLowBump_m);
  EXPECT_GT(StandsOff_m(composer, cast.topology, 0, kettle, 1), 2 * kLowBump_m)
      << "the handle itself stands off";
  tests::Report("look_horns_mm", 1000 * farthest_m);
}

// How wide the neck's lower end is: the row along the lower border of the parameter space.
float LowerEnd_m(face::Composer& composer, const face::Topology& topology, std::uint16_t a, std::uint16_t b,
                 float share_of_b) {
  face::Weights weights;
  weights.faces.Push(a, 1 - share_of_b);
  weights.faces.Push(b, share_of_b);
  weights.expressions.Push(0, 1);
  const auto cage = composer.Compose(weights, face::Detail::kCage).cage;
  const auto lowest = std::ranges::min_element(topology.uv, {}, [](const glm::vec2& uv) { return uv.y; });
  float widest_m = 0;
  for (std::size_t v = 0; v < cage.size(); ++v) {
    if (topology.uv[v].y < lowest->y + 1e-3F) widest_m = std::max(widest_m, 2 * std::abs(cage[v].x));
  }
  return widest_m;
}

TEST(Outgrowths, NecksCloseBetweenAHeadWithANeckAndOneWithout) {
  const face::Cast cast = tests::ClothedCast();
  face::Composer composer(cast);
  const std::uint16_t kettle = FaceNamed(cast, "kettle");
  for (std::uint16_t face = 0; face < cast.faces.size(); ++face) {
    if (face == kettle) continue;
    EXPECT_GT(LowerEnd_m(composer, cast.topology, face, kettle, 0), 0.05F) << cast.faces[face].name;
    for (const float share : {0.3F, 0.5F, 0.7F})
      EXPECT_LE(LowerEnd_m(composer, cast.topology, face, kettle, share), 0.008F) << cast.faces[face].name;
  }
}

TEST(Outgrowths, StayBetweenHeadsWithEars) {
  face::Cast cast = tests::ClothedCast();
  face::Weights weights;
  weights.faces.Push(0, 0.5F);
  weights.faces.Push(FaceNamed(cast, "dog"), 0.5F);
  weights.expressions.Push(0, 1);
  face::Composer composer(cast);
  const auto cage = composer.Compose(weights, face::Detail::kCage).cage;
  const std::vector<glm::vec3> with(cage.begin(), cage.end());
  for (face::Face& face : cast.faces) face.withdrawn.clear();
  face::Composer plain(cast);
  const auto without = plain.Compose(weights, face::Detail::kCage).cage;
  EXPECT_TRUE(std::ranges::equal(with, without));
}

// The dog's ears hang and swing with the tip farthest; no other face has anything that moves with them.
TEST(Outgrowths, TheDogsEarsAloneSwing) {
  const face::Cast cast = tests::ClothedCast();
  face::Composer composer(cast);
  for (std::uint16_t face = 0; face < cast.faces.size(); ++face) {
    face::Weights weights;
    weights.faces.Push(face, 1);
    weights.expressions.Push(0, 1);
    const auto cage = composer.Compose(weights, face::Detail::kCage).cage;
    const std::vector<glm::vec3> rest(cage.begin(), cage.end());
    for (face::Hanging& side : weights.hanging) side = {{0, 0.3F}, {0, 0.3F}};
    const auto swung = composer.Compose(weights, face::Detail::kCage).cage;
    float farthest_m = 0;
    std::size_t tip = 0, moved = 0;
    for (std::size_t v = 0; v < rest.size(); ++v) {
      const float by_m = glm::distance(rest[v], swung[v]);
      moved += by_m > 0 ? 1 : 0;
      if (by_m > farthest_m) farthest_m = by_m, tip = v;
    }
    if (cast.faces[face].name != "dog") {
      EXPECT_EQ(moved, 0U) << cast.faces[face].name;
      continue;
    }
    EXPECT_GT(moved, 100U);
    EXPECT_NEAR(farthest_m, 0.3F * 0.09F, 0.01F);
    EXPECT_LT(rest[tip].y, -0.02F) << "the lower end";
  }
}

}  // namespace
}  // namespace kaori
