// Paint of an imported head lies by its own lids and lips.
#include <gtest/gtest.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include "appliance/authoring/import/depth_view.h"
#include "appliance/authoring/import/lid_paint.h"
#include "appliance/authoring/import/paint_uvs.h"
#include "appliance/authoring/sculpt/cage.h"
#include "tests/appliance/authoring/import_head.h"

namespace kaori::import {
namespace {

constexpr PaintColour kUnder{10, 20, 30, 40};
constexpr LidColours kColours{.skin = {200, 180, 160, 50}, .liner = {0, 0, 0, 0}, .rim = {120, 0, 0, 0}};

class LidPaintTest : public ::testing::Test {
 protected:
  LidPaintTest() : head_(ShapeOfCast(DefaultShow().cast)), paint_(head_) {}

  // A point so far above (or, negative, below) the middle of an eye's upper (or lower) margin.
  glm::vec3 Beside(std::size_t side, float up_m) const {
    const LidMarks marks = MarksOf(*OpeningOf(head_, side), head_, side);
    return (up_m > 0 ? marks.upper : marks.lower) + glm::vec3(0, up_m, 0);
  }
  PaintColour At(const glm::vec3& at) const { return paint_.Over(kUnder, at, kColours); }

  HeadShape head_;
  LidPaint paint_;
};

TEST_F(LidPaintTest, DrawsALineOnTheUpperMarginAndARimOnTheLowerOne) {
  for (const std::size_t side : {0U, 1U}) {
    EXPECT_LT(At(Beside(side, 0.0002F))[0], 80) << side;
    EXPECT_GT(At(Beside(side, 0.004F))[0], 190) << "bare skin above the line";
    const PaintColour rim = At(Beside(side, -0.0002F));
    EXPECT_LT(rim[1], 140) << side;
    EXPECT_GT(rim[0], rim[1]) << "a rim is red";
  }
}

TEST_F(LidPaintTest, LeavesWhatIsFartherOffOrBehindAsItWas) {
  EXPECT_EQ(At(Beside(0, 0.012F)), kUnder);
  EXPECT_EQ(At(Beside(1, -0.012F)), kUnder);
  EXPECT_EQ(At(Beside(0, 0.0002F) - glm::vec3(0, 0, 0.05F)), kUnder) << "the back of the head";
  const PaintColour between = At(Beside(0, 0.007F));
  EXPECT_GT(between[0], kUnder[0]);
  EXPECT_LT(between[0], kColours.skin[0]);
}

TEST_F(LidPaintTest, DrawsNoLineIntoTheInnerCorner) {
  for (const std::size_t side : {0U, 1U}) {
    const auto opening = OpeningOf(head_, side);
    const auto& columns = opening->columns;
    const BallColumn& inner = side == 0 ? columns.front() : columns.back();
    const BallColumn& outer = side == 0 ? columns.back() : columns.front();
    const float z_m = head_.eyes[side].centre.z + head_.eyes[side].radius_m;
    EXPECT_GT(At({inner.x_m, inner.high_m + 0.0002F, z_m})[0], 190) << side;
    EXPECT_LT(At({outer.x_m, outer.high_m + 0.0002F, z_m})[0], 80) << side;
  }
}

TEST_F(LidPaintTest, PaintsNothingWhereThereAreNoEyes) {
  HeadShape blind = head_;
  for (auto& eye : blind.eyes) eye.radius_m = 0;
  const LidPaint none(blind);
  EXPECT_EQ(none.Over(kUnder, Beside(0, 0.0002F), kColours), kUnder);
  EXPECT_FALSE(none.DistanceOf(Beside(0, 0.0002F)));
}

TEST(InsideOfMouth, IsWhatLiesBehindTheLips) {
  const sculpt::Cage cage = sculpt::BuildCage();
  const HeadShape head = ShapeOfCast(DefaultShow().cast);
  const std::vector<bool> inside = InsideOfMouth(head);
  const std::vector<bool> seen = SeenFromFront(head);
  ASSERT_EQ(inside.size(), head.positions.size());
  EXPECT_GT(std::ranges::count(inside, true), 60);
  for (face::Index v = 0; v < inside.size(); ++v) {
    if (!inside[v]) continue;
    EXPECT_FALSE(seen[v]) << v;
    EXPECT_EQ(cage.key(v).region, sculpt::Region::kMouth) << v;
    EXPECT_GE(cage.key(v).b, sculpt::kLipContactRing) << v;
  }
}

TEST(PaintUvs, OfSkinThatIsSeenAreNoneOfTheInsideOfTheMouth) {
  const face::Cast& cast = DefaultShow().cast;
  const sculpt::Cage cage = sculpt::BuildCage();
  Findings findings;
  const Heads heads = SplitHeads({ExportedHead()}, 0.05F, findings);
  // The same head: each vertex lies on itself, but one beside the mouth, which lies within it.
  std::vector<Spot> spots;
  for (const face::Index v : heads.skin) spots.push_back({{v, v, v}, {1, 0, 0}, 0});
  const face::Index beside = cage.left[cage.half.At(sculpt::Region::kMouth, sculpt::kMouthCorner, 1)];
  const face::Index within = cage.left[cage.half.At(sculpt::Region::kMouth, sculpt::kMouthCorner, 9)];
  spots[beside].corners = {within, within, within};
  std::vector<glm::vec2> uv;
  for (const Spot& spot : spots) uv.push_back(spot.Of(cast.topology.texture));
  SettleUvs(heads, ShapeOfHeads(heads), spots, cast, uv);
  const glm::vec2 own = cast.topology.texture[beside];
  EXPECT_LT(glm::distance(uv[beside], own), 0.3F * glm::distance(cast.topology.texture[within], own));
}

}  // namespace
}  // namespace kaori::import
