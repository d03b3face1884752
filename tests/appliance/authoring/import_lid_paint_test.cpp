// Paint about the eyes of an imported head lies by its own lids.
#include <gtest/gtest.h>

#include "appliance/authoring/import/lid_paint.h"
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

}  // namespace
}  // namespace kaori::import
