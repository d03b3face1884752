// The painted mouth is found among noise, other paint and odd pictures.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "appliance/programs/lips/lip_meter.h"

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

  decode::Planes planes() const {
    const auto stride = static_cast<std::uint32_t>(width_);
    return {.y = {cb_, width_, height_, stride, 1},
            .cb = {cb_, width_, height_, stride, 1},
            .cr = {cr_, width_, height_, stride, 1}};
  }

  // The largest region, as the runs have it.
  std::optional<Region> Find() const {
    PaintMask mask;
    mask.Read(planes(), PaintKey({}));
    Regions regions;
    if (!regions.Find(mask)) return std::nullopt;
    const auto largest = regions.Largest(1, 1);
    return largest.empty() ? std::nullopt : std::optional(largest[0]);
  }

  // Measures one frame with a new meter.
  std::optional<Detection> Detect() const {
    LipMeter meter({}, {});
    meter.Measure(planes(), Time{} + std::chrono::seconds(1));
    return meter.detection();
  }

 private:
  int width_;
  int height_;
  std::vector<std::uint8_t> cb_;
  std::vector<std::uint8_t> cr_;
};

void ExpectBox(const std::optional<Region>& found, int left, int top, int right, int bottom) {
  ASSERT_TRUE(found);
  EXPECT_EQ(found->left, left);
  EXPECT_EQ(found->top, top);
  EXPECT_EQ(found->right, right);
  EXPECT_EQ(found->bottom, bottom);
}

TEST(PaintKey, TakesItsPaintInLightAndShadeAndNoSkinOrGrey) {
  const PaintKey blue({20, 60, 200});
  EXPECT_TRUE(blue.at(200, 104));
  EXPECT_TRUE(blue.at(165, 118)) << "in shade";
  EXPECT_FALSE(blue.at(128, 128));
  EXPECT_FALSE(blue.at(105, 155)) << "skin";
  EXPECT_FALSE(blue.at(128, 220)) << "a red nose";
  const PaintKey green({0, 160, 40});
  EXPECT_TRUE(green.at(80, 50));
  EXPECT_FALSE(green.at(200, 104));
  const PaintKey red({200, 20, 90});
  EXPECT_TRUE(red.at(132, 212));
  EXPECT_FALSE(red.at(107, 154)) << "skin";
  EXPECT_FALSE(red.at(98, 163)) << "skin in warm light";
  const PaintKey grey({128, 128, 128});
  EXPECT_FALSE(grey.at(128, 128)) << "grey is no paint";
  EXPECT_FALSE(grey.at(200, 104));
}

TEST(PaintKey, TakesMoreWithMoreSimilarityAndLessTintWithLessSpill) {
  const auto taken = [](const KeySettings& settings) {
    int count = 0;
    for (int cb = 0; cb < 256; ++cb)
      for (int cr = 0; cr < 256; ++cr)
        count +=
            PaintKey({}, settings).Soft(static_cast<std::uint8_t>(cb), static_cast<std::uint8_t>(cr)) >= 0.5F;
    return count;
  };
  const int plain = taken({});
  EXPECT_GT(taken({.similarity = 250}), plain * 5 / 4);
  EXPECT_LT(taken({.similarity = 70}), plain * 3 / 4);
  EXPECT_LT(taken({.spill = 200}), plain);
  EXPECT_GT(taken({.spill = 40}), plain);
  const auto softest = [](float smoothness) {
    return PaintKey({}, {.smoothness = smoothness}).Soft(200, 128 + 8);  // Outside, but not far.
  };
  EXPECT_LT(softest(20), softest(200)) << "a wide edge lets more through";
}

TEST(PaintMask, IsTheKeySampleBySampleInEveryPacking) {
  std::mt19937 random(7);
  constexpr int kWidth = 150;  // No multiple of a block.
  constexpr int kHeight = 9;
  std::vector<std::uint8_t> yuyv(std::size_t{kWidth} * kHeight * 4);
  for (auto& byte : yuyv) byte = static_cast<std::uint8_t>(random() % 16 != 0 ? 200 : random());
  for (std::size_t n = 0; n < yuyv.size(); n += 4)
    if (n / 4 % kWidth < 70) yuyv[n + 1] = 200, yuyv[n + 3] = 104;
  std::vector<std::uint8_t> pairs, cb, cr;
  for (std::size_t n = 0; n < yuyv.size(); n += 4) {
    pairs.insert(pairs.end(), {yuyv[n + 1], yuyv[n + 3]});
    cb.push_back(yuyv[n + 1]);
    cr.push_back(yuyv[n + 3]);
  }
  const auto planes = [&](const std::vector<std::uint8_t>& bytes, std::uint32_t step, std::size_t first,
                          std::size_t second, const std::vector<std::uint8_t>& other) {
    return decode::Planes{.y = {bytes, kWidth, kHeight, kWidth * step, step},
                          .cb = {std::span(bytes).subspan(first), kWidth, kHeight, kWidth * step, step},
                          .cr = {std::span(other).subspan(second), kWidth, kHeight, kWidth * step, step}};
  };
  const PaintKey key({});
  const auto votes = [&](int x, int y) {
    int count = 0;
    for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      if (x + dx < 0 || x + dx >= kWidth || y + dy < 0 || y + dy >= kHeight) continue;
      const auto n = static_cast<std::size_t>((y + dy) * kWidth + x + dx);
      count += key.at(cb[n], cr[n]) ? 1 : 0;
    }
    return count;
  };
  PaintMask mask;
  int painted = 0;
  for (const auto& picture :
       {planes(yuyv, 4, 1, 3, yuyv), planes(pairs, 2, 0, 1, pairs), planes(cb, 1, 0, 0, cr)}) {
    mask.Read(picture, key);
    ASSERT_EQ(mask.grid().width, kWidth);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const bool set = (mask.row(y)[static_cast<std::size_t>(x) / 64] >> (x % 64) & 1) != 0;
        ASSERT_EQ(set, votes(x, y) >= 3) << x << ", " << y << ", step " << picture.cb.step_bytes;
        painted += set ? 1 : 0;
      }
  }
  EXPECT_GT(painted, 3 * 70 * 8);
}

TEST(Region, IsTheLargestPatchOfPaint) {
  Picture picture(320, 240);
  picture.Blue(100, 120, 200, 160);
  picture.Blue(10, 10, 30, 20);
  ExpectBox(picture.Find(), 100, 120, 200, 160);
  EXPECT_NEAR(picture.Find()->area, 4000, 4) << "the vote rounds corners";
}

TEST(Region, FollowsARingRound) {
  Picture picture(320, 240);
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x) {
      const double r = std::hypot((x - 160) / 60.0, (y - 120) / 80.0);
      if (r <= 1 && r > 0.8) picture.Paint(x, y, 200, 110);
    }
  const auto found = picture.Find();
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->width(), 121, 2);
  EXPECT_NEAR(found->height(), 161, 2);
}

TEST(Region, IsNoneWithoutPaint) {
  EXPECT_FALSE(Picture(320, 240).Find());
  EXPECT_FALSE(Picture(0, 0).Find());
  EXPECT_FALSE(Picture(0, 0).Detect());
}

TEST(Mouth, TakesBothLipsWhereAnOpenMouthSplitsThem) {
  Picture picture(320, 240);
  picture.Blue(100, 100, 200, 112);
  picture.Blue(110, 150, 190, 160);
  const auto detection = picture.Detect();
  ASSERT_TRUE(detection);
  EXPECT_NEAR(detection->contour.width_px, 100, 1);
  EXPECT_NEAR(detection->contour.height_px, 60, 1);
  EXPECT_NEAR(detection->contour.opening_px, 38, 1);
}

TEST(Mouth, IsSteadyUnderSaltAndPepper) {
  std::mt19937 random(4);
  for (int round = 0; round < 20; ++round) {
    Picture picture(320, 240);
    picture.Blue(100, 120, 200, 160);
    for (int i = 0; i < 1500; ++i) {
      const auto x = static_cast<int>(random() % 320);
      const auto y = static_cast<int>(random() % 240);
      i % 2 == 0 ? picture.Paint(x, y, 200, 110) : picture.Paint(x, y, 128, 128);
    }
    const auto detection = picture.Detect();
    ASSERT_TRUE(detection);
    EXPECT_NEAR(detection->contour.width_px, 100, 5);
    EXPECT_NEAR(detection->contour.height_px, 40, 5);
  }
}

TEST(Mouth, IsNotToBeHadFromPureNoise) {
  for (const int width : {320, 1920}) {
    Picture noise(width, 240);
    std::mt19937 random(4);
    for (int y = 0; y < 240; ++y)
      for (int x = 0; x < width; ++x)
        noise.Paint(x, y, static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()));
    EXPECT_FALSE(noise.Detect());
  }
}

TEST(Gauge, TrustsNeitherSpecksNorBlueWalls) {
  const auto quality = [](int left, int top, int right, int bottom) {
    Picture picture(320, 240);
    picture.Blue(left, top, right, bottom);
    MouthGauge gauge({});
    return gauge.Measure(picture.Detect(), Time{} + std::chrono::seconds(1)).quality;
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
      << "and follows within a frame when it moves";
}

}  // namespace
}  // namespace kaori::lips
