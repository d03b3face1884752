// Ears swing as ears do: thrown by a turn, off the head, and the tip after the root.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "appliance/core/performance/swing.h"

namespace kaori {
namespace {

using performance::Chain;
using performance::SwingChains;
using Sides = std::array<Chain, 2>;

constexpr float kFrame_s = 1.0F / 60;

// Steps of a head that turns to one side within a quarter of a second, and looks there.
template <class Each>
void Turn(Sides& sides, float yaw_rad, const Each& each) {
  for (int n = 0; n < 60; ++n) {
    const float way = std::min(1.0F, static_cast<float>(n) / 15);
    SwingChains(sides, {.yaw_rad = yaw_rad * way}, kFrame_s);
    each(n);
  }
}

TEST(Swing, ATurnThrowsTheOneEarForwardsAndTheOtherBackwards) {
  Sides sides{};
  float left = 0, right = 0;
  Turn(sides, 0.5F, [&](int n) {
    if (n != 10) return;
    left = sides[0].upper.angle_rad.y;
    right = sides[1].upper.angle_rad.y;
  });
  EXPECT_GT(left, 0.05F) << "the head turns to the left: the left ear stays behind, which is in front";
  EXPECT_NEAR(right, -left, 1e-6F);
}

TEST(Swing, TheTipFollowsTheRoot) {
  Sides sides{};
  int root_at = 0, tip_at = 0;
  float root = 0, tip = 0;
  Turn(sides, 0.5F, [&](int n) {
    if (sides[0].upper.angle_rad.y > root) root = sides[0].upper.angle_rad.y, root_at = n;
    if (sides[0].lower.angle_rad.y > tip) tip = sides[0].lower.angle_rad.y, tip_at = n;
  });
  EXPECT_GT(tip_at, root_at + 1);
  EXPECT_GT(tip, 0.5F * root);
}

TEST(Swing, NoEarGoesIntoTheHead) {
  Sides sides{};
  float inwards = 0, outwards = 0;
  for (int n = 0; n < 240; ++n) {
    SwingChains(sides, {.roll_rad = 0.5F * std::sin(0.15F * static_cast<float>(n))}, kFrame_s);
    for (const performance::Sway& joint : {sides[0].upper, sides[0].lower}) {
      inwards = std::min(inwards, joint.angle_rad.x);
      outwards = std::max(outwards, joint.angle_rad.x);
    }
  }
  EXPECT_GE(inwards, -0.0401F);
  EXPECT_GT(outwards, 0.1F);
}

TEST(Swing, StaysBoundedWhateverTheHeadDoes) {
  Sides sides{};
  for (int n = 0; n < 400; ++n) {
    const float far = n % 2 == 0 ? 3 : -3;
    SwingChains(sides, {.yaw_rad = far, .pitch_rad = -far, .roll_rad = far}, n % 3 == 0 ? 0.1F : 0.004F);
    for (const Chain& chain : sides)
      for (const performance::Sway& joint : {chain.upper, chain.lower})
        EXPECT_TRUE(std::abs(joint.angle_rad.x) <= 0.6F && std::abs(joint.angle_rad.y) <= 0.6F);
  }
  const Sides before = sides;
  SwingChains(sides, {}, 0);
  EXPECT_EQ(sides[0].upper.angle_rad, before[0].upper.angle_rad) << "a step of no time";
}

}  // namespace
}  // namespace kaori
