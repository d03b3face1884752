// What the studio drew, made small.
#include <gtest/gtest.h>

#include <cstdlib>

#include "appliance/core/performance/animate.h"
#include "appliance/programs/stage/studio.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

constexpr int kWidth_px = 96, kHeight_px = 54;

class SmallPictureTest : public PackTest {
 protected:
  SmallPictureTest() : studio_(stage::Studio::Open(SmallShow()).value()) {}

  // R, G, B, X, the bottom row first.
  const std::vector<std::uint8_t>& Draw() {
    const auto scene =
        performance::Animate(performance::Opening(studio_->show(), {}, {}), {}, {}, studio_->show(), {})
            .scene;
    EXPECT_TRUE(studio_->Draw(
        scene, {.width_px = kWidth_px, .height_px = kHeight_px, .target = ports::PixelMemory{drawn_}}));
    return drawn_;
  }
  // The mean of four points of the picture, whose rows are counted from its top.
  int Mean(int x, int y, int colour) const {
    int sum = 0;
    for (const int row : {2 * y, 2 * y + 1})
      for (const int column : {2 * x, 2 * x + 1})
        sum += drawn_[std::size_t(((kHeight_px - 1 - row) * kWidth_px + column) * 4 + colour)];
    return sum / 4;
  }

  std::unique_ptr<stage::Studio> studio_;
  std::vector<std::uint8_t> drawn_ = std::vector<std::uint8_t>(std::size_t(kWidth_px) * kHeight_px * 4);
};

TEST_F(SmallPictureTest, IsThePictureWithItsTopRowFirst) {
  stage::SmallImage small;
  EXPECT_FALSE(studio_->ReadSmall(48, small)) << "nothing was drawn";
  Draw();
  ASSERT_TRUE(studio_->ReadSmall(48, small));
  ASSERT_EQ(small.width_px, 48);
  ASSERT_EQ(small.height_px, 27);
  long off = 0, shades = 0;
  for (int y = 0; y < 27; ++y)
    for (int x = 0; x < 48; ++x)
      for (int colour = 0; colour < 3; ++colour) {
        off += std::abs(small.pixels[std::size_t((y * 48 + x) * 4 + colour)] - Mean(x, y, colour));
        shades += std::abs(Mean(x, y, colour) - Mean(x, 26 - y, colour));
      }
  EXPECT_LT(off, 48 * 27 * 3 * 3) << "light is averaged as light, not as its codes";
  EXPECT_GT(shades, 2 * off) << "upside down it would be another one";
}

TEST_F(SmallPictureTest, IsReadInTwoSizesInTurn) {
  Draw();
  stage::SmallImage small, smaller;
  for (int turn = 0; turn < 2; ++turn) {
    ASSERT_TRUE(studio_->ReadSmall(48, small));
    ASSERT_TRUE(studio_->ReadSmall(24, smaller));
  }
  EXPECT_EQ(small.pixels.size(), 48U * 27 * 4);
  EXPECT_EQ(smaller.pixels.size(), 24U * 13 * 4);
  EXPECT_NEAR(smaller.pixels[0], small.pixels[0], 8);
}

TEST_F(SmallPictureTest, IsNeverLargerThanThePicture) {
  Draw();
  stage::SmallImage small;
  ASSERT_TRUE(studio_->ReadSmall(480, small));
  EXPECT_EQ(small.width_px, kWidth_px);
}

}  // namespace
}  // namespace kaori::tests
