// Finding the painted mouth among noise, other paint and odd pictures.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "appliance/lips/mouth_gauge.h"
#include "appliance/lips/paint_key.h"
#include "appliance/lips/region.h"

namespace kaori::lips {
namespace {

// A picture of Cb and Cr planes alone, grey at first.
class Picture {
 public:
  Picture(int width, int height) : width_(width), height_(height) {
    cb_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 128);
    cr_ = cb_;
  }

  void Paint(int x, int y, std::uint8_t cb, std::uint8_t cr) {
    cb_[static_cast<std::size_t>(y * width_ + x)] = cb;
    cr_[static_cast<std::size_t>(y * width_ + x)] = cr;
  }

  void Blue(int left, int top, int right, int bottom) {
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) Paint(x, y, 200, 110);
  }

  camera::Planes planes() const {
    const auto stride = static_cast<std::uint32_t>(width_);
    return {.y = {cb_, width_, height_, stride, 1},
            .cb = {cb_, width_, height_, stride, 1},
            .cr = {cr_, width_, height_, stride, 1}};
  }

  std::optional<Found> Find() const { return RegionFinder().Find(planes(), PaintKey({})); }

 private:
  int width_;
  int height_;
  std::vector<std::uint8_t> cb_;
  std::vector<std::uint8_t> cr_;
};

void ExpectBox(const std::optional<Found>& found, int left, int top, int right, int bottom) {
  ASSERT_TRUE(found);
  EXPECT_EQ(found->mouth.left, left);
  EXPECT_EQ(found->mouth.top, top);
  EXPECT_EQ(found->mouth.right, right);
  EXPECT_EQ(found->mouth.bottom, bottom);
}

TEST(PaintKey, TakesItsPaintInLightAndShadeAndNoSkinOrGrey) {
  const PaintKey blue({20, 60, 200});
  EXPECT_EQ(blue.at(200, 104), 1);
  EXPECT_EQ(blue.at(165, 118), 1) << "in shade";
  EXPECT_EQ(blue.at(128, 128), 0);
  EXPECT_EQ(blue.at(105, 155), 0) << "skin";
  EXPECT_EQ(blue.at(128, 220), 0) << "a red nose";
  const PaintKey green({0, 160, 40});
  EXPECT_EQ(green.at(80, 50), 1);
  EXPECT_EQ(green.at(200, 104), 0);
  const PaintKey grey({128, 128, 128});
  EXPECT_EQ(grey.at(128, 128), 0) << "grey is no paint";
}

TEST(Region, IsTheLargestPatchOfPaint) {
  Picture picture(320, 240);
  picture.Blue(100, 120, 200, 160);
  picture.Blue(10, 10, 30, 20);
  ExpectBox(picture.Find(), 100, 120, 200, 160);
  EXPECT_EQ(picture.Find()->mouth.area, 4000);
  EXPECT_EQ(picture.Find()->painted, 4200);
}

TEST(Region, TakesBothLipsOfAMouthThatSplitsThem) {
  Picture picture(320, 240);
  picture.Blue(100, 100, 200, 112);
  picture.Blue(110, 150, 190, 160);
  ExpectBox(picture.Find(), 100, 100, 200, 160);
}

TEST(Region, FollowsARingRound) {
  Picture picture(320, 240);
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x) {
      const double r = std::hypot((x - 160) / 60.0, (y - 120) / 80.0);
      if (r <= 1 && r > 0.8) picture.Paint(x, y, 200, 110);
    }
  ExpectBox(picture.Find(), 100, 41, 221, 200);  // Its single outermost samples count as noise.
}

TEST(Region, IsSteadyUnderSaltAndPepper) {
  std::mt19937 random(4);
  for (int round = 0; round < 20; ++round) {
    Picture picture(320, 240);
    picture.Blue(100, 120, 200, 160);
    for (int i = 0; i < 1500; ++i) {
      const auto x = static_cast<int>(random() % 320);
      const auto y = static_cast<int>(random() % 240);
      i % 2 == 0 ? picture.Paint(x, y, 200, 110) : picture.Paint(x, y, 128, 128);
    }
    const auto found = picture.Find();
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->mouth.width(), 100, 5);
    EXPECT_NEAR(found->mouth.height(), 40, 5);
  }
}

TEST(Region, IsNoneWithoutPaintAndNoneInPureNoise) {
  EXPECT_FALSE(Picture(320, 240).Find());
  EXPECT_FALSE(Picture(0, 0).Find());
  Picture noise(1920, 1080);
  std::mt19937 random(4);
  for (int y = 0; y < 1080; ++y)
    for (int x = 0; x < 1920; ++x)
      noise.Paint(x, y, static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()));
  EXPECT_FALSE(noise.Find());
}

TEST(Gauge, TrustsNeitherSpecksNorBlueWalls) {
  const auto quality = [](int left, int top, int right, int bottom) {
    Picture picture(320, 240);
    picture.Blue(left, top, right, bottom);
    MouthGauge gauge({});
    return gauge.Measure(picture.Find(), picture.planes(), Time{} + std::chrono::seconds(1)).quality;
  };
  EXPECT_GT(quality(100, 120, 200, 160), 0.9F);
  EXPECT_EQ(quality(0, 0, 320, 240), 0.0F);
  EXPECT_EQ(quality(100, 100, 106, 103), 0.0F);
  EXPECT_EQ(quality(100, 0, 104, 240), 0.0F);
  EXPECT_LE(quality(0, 120, 100, 160), 0.5F) << "cut by the picture's edge";
}

TEST(Gauge, IsStillWhenTheMouthIsStill) {
  OneEuro filter;
  std::mt19937 random(1);
  Time at = Time{} + std::chrono::seconds(1);
  float low = 2;
  float high = 0;
  for (int i = 0; i < 300; ++i) {
    at += std::chrono::milliseconds(33);
    const float noise = static_cast<float>(random() % 1000) / 1000.0F - 0.5F;
    const float value = filter.Filter(1 + 0.02F * noise, at);
    if (i < 10) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  EXPECT_LT(high - low, 0.017F);
  EXPECT_GT(filter.Filter(1.5F, at + std::chrono::milliseconds(33)), 1.4F)
      << "and there in a frame when it moves";
}

}  // namespace
}  // namespace kaori::lips
