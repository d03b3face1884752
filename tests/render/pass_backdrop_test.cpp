// Backdrops: each kind is a picture of its own, they fade without a dip, and stand still.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/render/pass_studio.h"

namespace kaori {
namespace {

using scene::BackdropKind;
using tests::Difference;
using tests::PassStudio;
using tests::Picture;

constexpr int kBackdropWidth_px = 160;
constexpr int kBackdropHeight_px = 90;

scene::Backdrop Drop(int kind) {
  return {{0.30F, 0.24F, 0.20F}, {0.10F, 0.07F, 0.12F}, static_cast<BackdropKind>(kind), {1, 0.8F, 0.5F}, 0};
}

// Nobody stands before it.
scene::Scene Empty(int kind) {
  scene::Scene scene = tests::PlainScene(scene::Style::kSoft);
  scene.camera.target_m.y = 1;
  scene.backdrop = Drop(kind);
  return scene;
}

Picture BackdropDraw(const scene::Scene& scene) {
  return PassStudio::Shared().Draw(scene, kBackdropWidth_px, kBackdropHeight_px);
}

double Mean(const Picture& picture) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.bytes.size(); ++i) sum += i % 4 == 3 ? 0 : picture.bytes[i];
  return sum / (static_cast<double>(picture.bytes.size()) * 0.75);
}

TEST(Backdrop, IsAPictureOfItsOwnForEachKind) {
  std::vector<Picture> drawn;
  for (int kind = 0; kind < scene::kBackdropKindCount; ++kind) {
    drawn.push_back(BackdropDraw(Empty(kind)));
    EXPECT_GT(Mean(drawn.back()), 10) << kind;
    for (int other = 0; other < kind; ++other)
      EXPECT_GT(Difference(drawn.back(), drawn[static_cast<std::size_t>(other)]), 2) << kind << ", " << other;
  }
}

TEST(Backdrop, IsBlackWithoutLight) {
  for (int kind = 0; kind < scene::kBackdropKindCount; ++kind) {
    scene::Scene scene = Empty(kind);
    scene.light.exposure = 0;
    EXPECT_EQ(Mean(BackdropDraw(scene)), 0) << kind;
  }
}

TEST(Backdrop, FadesIntoTheNextWithoutADip) {
  scene::Scene scene = Empty(static_cast<int>(BackdropKind::kCurtain));
  scene.fading[1].backdrop = Drop(static_cast<int>(BackdropKind::kNight));
  std::vector<double> means;
  for (const float weight : {0.0F, 0.25F, 0.5F, 0.75F, 1.0F}) {
    scene.fading[1].weight = weight;
    means.push_back(Mean(BackdropDraw(scene)));
  }
  const double step = (means.back() - means.front()) / 4;
  ASSERT_GT(std::abs(step), 0.5) << "the two look alike";
  for (std::size_t i = 0; i < means.size(); ++i)
    EXPECT_NEAR(means[i], means[0] + step * static_cast<double>(i), 1.5) << i;
}

TEST(Backdrop, IsThatOfFourWhenFourFade) {
  scene::Scene scene = Empty(static_cast<int>(BackdropKind::kRays));
  for (int i = 0; i < 3; ++i) scene.fading[static_cast<std::size_t>(i)] = {Drop(i + 1), 0.25F};
  double mean = Mean(BackdropDraw(Empty(static_cast<int>(BackdropKind::kRays)))) / 4;
  for (int i = 0; i < 3; ++i) mean += Mean(BackdropDraw(Empty(i + 1))) / 4;
  EXPECT_NEAR(Mean(BackdropDraw(scene)), mean, 6);
}

TEST(Backdrop, StandsStillAndComesBackAsItWas) {
  PassStudio& studio = PassStudio::Shared();
  const auto canvas = gl::Canvas::Make({.width_px = kBackdropWidth_px, .height_px = kBackdropHeight_px});
  ASSERT_TRUE(canvas) << canvas.error().message();
  scene::Scene scene = tests::PlainScene(scene::Style::kSoft);
  scene.backdrop = Drop(static_cast<int>(BackdropKind::kKitchen));
  const Picture before = studio.DrawOn(*canvas, scene);
  EXPECT_EQ(studio.DrawOn(*canvas, scene).bytes, before.bytes);
  scene::Scene other = scene;
  for (int kind = 0; kind < scene::kBackdropKindCount; ++kind) {
    other.fading[0] = {Drop(kind), 0.4F};
    if (other.fading[0].backdrop == scene.backdrop) continue;
    EXPECT_GT(Difference(studio.DrawOn(*canvas, other), before), 0.2) << kind;
  }
  EXPECT_EQ(studio.DrawOn(*canvas, scene).bytes, before.bytes);
}

TEST(Backdrop, CoversAStageOfAnyShape) {
  for (const auto& [width, height] : {std::pair{1, 1}, {300, 40}, {40, 300}})
    for (int kind = 0; kind < scene::kBackdropKindCount; ++kind)
      EXPECT_GT(Mean(PassStudio::Shared().Draw(Empty(kind), width, height)), 1) << width << ", " << kind;
}

TEST(Backdrop, ShowsAPictureOfTheShow) {
  scene::Scene scene = Empty(static_cast<int>(BackdropKind::kPicture));
  const Picture picture = BackdropDraw(scene);  // The studio's first texture is one colour.
  const std::uint8_t* middle = picture.at(kBackdropWidth_px / 2, kBackdropHeight_px / 2);
  EXPECT_NEAR(middle[0], 230, 3);
  EXPECT_NEAR(middle[1], 190, 3);
  EXPECT_NEAR(middle[2], 170, 3);
}

TEST(Backdrop, IsPlainWhereThePictureIsNotThere) {
  const Picture plain = BackdropDraw(Empty(static_cast<int>(BackdropKind::kGradient)));
  for (const int picture : {-1, 99}) {
    scene::Scene scene = Empty(static_cast<int>(BackdropKind::kPicture));
    scene.backdrop.picture = picture;
    EXPECT_LT(Difference(BackdropDraw(scene), plain), 0.5) << picture;
  }
}

}  // namespace
}  // namespace kaori
