#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hw-sim/evening/allocations.h"
#include "tests/render/pass_studio.h"

namespace kaori {
namespace {

using scene::Style;
using tests::Difference;
using tests::PassStudio;
using tests::Picture;
using tests::PlainScene;

constexpr Style kStyles[] = {Style::kWire, Style::kFlat, Style::kBare, Style::kHair, Style::kSoft};

scene::Scene Between(Style a, Style b, float share) {
  scene::Scene scene = PlainScene(a);
  scene.styles[static_cast<std::size_t>(a)] = 1 - share;
  scene.styles[static_cast<std::size_t>(b)] += share;
  return scene;
}

TEST(Painter, DrawsEachStyleInAWayOfItsOwn) {
  PassStudio& studio = PassStudio::Shared();
  for (const Style a : kStyles) {
    for (const Style b : kStyles) {
      if (a >= b) continue;
      EXPECT_GT(Difference(studio.Draw(PlainScene(a)), studio.Draw(PlainScene(b))), 0.3)
          << static_cast<int>(a) << " and " << static_cast<int>(b);
    }
  }
}

TEST(Painter, DrawsTheSamePictureOfTheSameScene) {
  PassStudio& studio = PassStudio::Shared();
  for (const Style style : kStyles) {
    EXPECT_EQ(studio.Draw(PlainScene(style)).bytes, studio.Draw(PlainScene(style)).bytes);
  }
}

// Each step of a fade goes farther from where it started and comes nearer to where it ends.
void ExpectMonotone(Style from, Style to) {
  PassStudio& studio = PassStudio::Shared();
  const Picture start = studio.Draw(PlainScene(from));
  const Picture end = studio.Draw(PlainScene(to));
  double gone = -1e-9;
  double left = 1e9;
  for (int step = 0; step <= 8; ++step) {
    const Picture now = studio.Draw(Between(from, to, static_cast<float>(step) / 8));
    EXPECT_GT(Difference(start, now), gone) << step;
    EXPECT_LT(Difference(end, now), left) << step;
    gone = Difference(start, now);
    left = Difference(end, now);
  }
  EXPECT_EQ(left, 0);
}

TEST(Painter, FadesFromWireToFlatWithoutTurningBack) {
  ExpectMonotone(Style::kWire, Style::kFlat);
}
TEST(Painter, FadesFromFlatToBareWithoutTurningBack) {
  ExpectMonotone(Style::kFlat, Style::kBare);
}
TEST(Painter, FadesFromHairToSoftWithoutTurningBack) {
  ExpectMonotone(Style::kHair, Style::kSoft);
}
TEST(Painter, FadesFromSoftToWireWithoutTurningBack) {
  ExpectMonotone(Style::kSoft, Style::kWire);
}

TEST(Painter, FadesByHalfInLinearLight) {
  PassStudio& studio = PassStudio::Shared();
  scene::Scene scene = Between(Style::kFlat, Style::kWire, 0.5F);
  scene.backdrop = {{1, 1, 1}, {1, 1, 1}};
  // White, and a tenth of it behind the wires: 0.55 of white, which sRGB codes as 196.
  EXPECT_NEAR(studio.Draw(scene).at(1, 60)[0], 196, 1);
}

TEST(Painter, CodesHalfOfTheLightAs188) {
  PassStudio& studio = PassStudio::Shared();
  scene::Scene scene = PlainScene(Style::kSoft);
  scene.backdrop = {{0.5F, 0.5F, 0.5F}, {0.5F, 0.5F, 0.5F}};
  const Picture picture = studio.Draw(scene);
  EXPECT_NEAR(picture.at(1, 60)[0], 188, 1);  // Beside the figure,
  scene.camera.target_m.y = 1;                // and where samples were laid.
  EXPECT_NEAR(studio.Draw(scene).at(80, 60)[1], 188, 1);
}

TEST(Painter, KeepsPaintThroughTheSamples) {
  PassStudio& studio = PassStudio::Shared();
  scene::Scene scene = PlainScene(Style::kFlat);
  scene.light.key = {0, 0, 1};
  const Picture picture = studio.Draw(scene);
  // Red is painted 0.6, green 0.5, blue 0.4; whatever the light, their order and ratio stay.
  const std::uint8_t* cheek = picture.at(80, 45);
  const auto linear = [](int code) { return std::pow((code / 255.0 + 0.055) / 1.055, 2.4); };
  EXPECT_NEAR(linear(cheek[1]) / linear(cheek[0]), 0.5 / 0.6, 0.02);
  EXPECT_NEAR(linear(cheek[2]) / linear(cheek[0]), 0.4 / 0.6, 0.02);
}

TEST(Painter, ShowsNothingInTheDark) {
  scene::Scene scene = PlainScene(Style::kSoft);
  scene.light.exposure = 0;
  scene.backdrop = {{0, 0, 0}, {0, 0, 0}};
  const Picture picture = PassStudio::Shared().Draw(scene);
  for (std::size_t i = 0; i < picture.bytes.size(); ++i) {
    const bool unused = i % 4 == 3;
    ASSERT_TRUE(unused || picture.bytes[i] == 0) << i;
  }
}

TEST(Painter, LeavesTheBackdropAloneWhenTheFigureHasLeft) {
  PassStudio& studio = PassStudio::Shared();
  for (const Style style : {Style::kSoft, Style::kWire}) {
    scene::Scene scene = PlainScene(style);
    scene.backdrop = {{0.2F, 0.4F, 0.6F}, {0.6F, 0.4F, 0.2F}};
    const Picture there = studio.Draw(scene);
    scene.present = 0;
    const Picture empty = studio.Draw(scene);
    scene.camera.target_m.y = 3;  // Looks past the figure.
    EXPECT_LT(Difference(empty, studio.Draw(scene)), 0.01) << static_cast<int>(style);
    EXPECT_GT(Difference(empty, there), 1);
  }
}

TEST(Painter, LeavesStepByStepWithoutTurningBack) {
  PassStudio& studio = PassStudio::Shared();
  scene::Scene scene = PlainScene(Style::kSoft);
  const Picture there = studio.Draw(scene);
  double gone = -1e-9;
  for (int step = 0; step <= 8; ++step) {
    scene.present = 1 - static_cast<float>(step) / 8;
    const double now = Difference(there, studio.Draw(scene));
    EXPECT_GT(now, gone) << step;
    gone = now;
  }
}

TEST(Painter, MixesTheSkinsOfFacesThatCrossFade) {
  PassStudio& studio = PassStudio::Shared();
  scene::Scene scene = PlainScene(Style::kBare);
  const auto blue_over_red = [&](float share) {
    scene.weights.faces.clear();
    scene.weights.faces.Push(0, 1 - share);
    scene.weights.faces.Push(1, share);
    const std::uint8_t* cheek = studio.Draw(scene).at(80, 45);
    return static_cast<double>(cheek[2]) / cheek[0];
  };
  EXPECT_LT(blue_over_red(0), blue_over_red(0.5F));
  EXPECT_LT(blue_over_red(0.5F), blue_over_red(1));
}

TEST(Painter, TurnsTheHeadButNotTheShoulders) {
  PassStudio& studio = PassStudio::Shared();
  scene::Scene scene = PlainScene(Style::kHair);
  const Picture ahead = studio.Draw(scene);
  scene.head.yaw_rad = 0.6F;
  const Picture turned = studio.Draw(scene);
  EXPECT_NE(ahead.bytes, turned.bytes);
  for (int x = 50; x < 110; ++x) {
    EXPECT_EQ(ahead.at(x, 1)[2], turned.at(x, 1)[2]) << x;
  }
}

TEST(Painter, SurvivesNumbersThatAreNone) {
  PassStudio& studio = PassStudio::Shared();
  const Picture good = studio.Draw(PlainScene(Style::kSoft));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  scene::Scene scene;
  scene.weights.faces.Push(0, nan);
  scene.weights.expressions.Push(60000, 1e30F);
  scene.gaze[0] = {nan, -nan};
  scene.head = {nan, nan, nan, {nan, nan, nan}};
  scene.styles = {nan, nan, nan, nan, nan};
  scene.light = {{nan, 0, 0}, nan};
  scene.camera = {{nan, nan, nan}, nan, nan, nan, nan};
  scene.backdrop = {{nan, 0, 0}, {0, nan, 0}};
  scene.hair_sway_rad.fill({nan, nan});
  scene.breath = nan;
  EXPECT_LT(Difference(studio.Draw(scene), good), 3);
}

TEST(Painter, WarmsUpWithoutTouchingThePicture) {
  PassStudio& studio = PassStudio::Shared();
  const Picture before = studio.Draw(PlainScene(Style::kSoft));
  int steps = 1;
  while (studio.painter().WarmUpStep()) ASSERT_LT(++steps, 100);
  EXPECT_GT(steps, 1);
  EXPECT_FALSE(studio.painter().WarmUpStep()) << "once is enough";
  EXPECT_EQ(studio.Draw(PlainScene(Style::kSoft)).bytes, before.bytes);
}

// The head turns, sinks out of the picture and comes back, in all styles and before other backdrops.
scene::Scene RestlessScene(int frame) {
  scene::Scene scene = PlainScene(kStyles[frame / 7 % scene::kStyleCount]);
  scene.head.yaw_rad = 0.7F * std::sin(static_cast<float>(frame));
  scene.head.shift_m.x = 0.1F * std::sin(2.3F * static_cast<float>(frame));
  scene.camera.target_m.y = frame % 9 == 8 ? 0.9F : 0.0F;
  scene.hair_sway_rad.fill({0.4F * std::sin(1.7F * static_cast<float>(frame)), 0});
  if (frame % 11 > 7) scene.backdrop.top = {0.5F, 0.1F, 0.1F};
  return scene;
}

TEST(Painter, LeavesNoTraceOfEarlierFramesOnACanvas) {
  PassStudio& studio = PassStudio::Shared();
  const auto canvas = gl::Canvas::Make({.width_px = 160, .height_px = 120});
  ASSERT_TRUE(canvas) << canvas.error().message();
  for (int frame = 0; frame < 40; ++frame) {
    const scene::Scene scene = RestlessScene(frame);
    ASSERT_EQ(studio.DrawOn(*canvas, scene).bytes, studio.Draw(scene).bytes) << frame;
  }
}

TEST(Painter, CountsOnNothingWhereAnotherPainterHasDrawn) {
  PassStudio& studio = PassStudio::Shared();
  const auto other = passes::Painter::Open(studio.context(), studio.cast());
  ASSERT_TRUE(other) << other.error().message();
  const auto canvas = gl::Canvas::Make({.width_px = 160, .height_px = 120});
  ASSERT_TRUE(canvas) << canvas.error().message();
  scene::Scene aside = PlainScene(Style::kSoft);
  aside.head.shift_m.x = 0.12F;
  const scene::Scene scene = PlainScene(Style::kSoft);
  const Picture wanted = studio.DrawOn(*canvas, scene);
  (*other)->Draw(aside, *canvas);
  EXPECT_EQ(studio.DrawOn(*canvas, scene).bytes, wanted.bytes);
}

TEST(Painter, SpreadsTheBackdropsStepsOverPixels) {
  scene::Scene scene = PlainScene(Style::kSoft);
  scene.camera.target_m.y = 1;  // Nobody there.
  const Picture picture = PassStudio::Shared().Draw(scene, 160, 400);
  int mixed = 0;
  for (int y = 0; y < picture.height_px; ++y) {
    const auto [low, high] = [&] {
      std::pair<int, int> range{255, 0};
      for (int x = 0; x < picture.width_px; ++x) {
        const int code = picture.at(x, y)[2];
        range = {std::min(range.first, code), std::max(range.second, code)};
      }
      return range;
    }();
    EXPECT_LE(high - low, 2) << y;
    mixed += high > low ? 1 : 0;
  }
  EXPECT_GT(mixed, picture.height_px / 2);
}

TEST(Painter, DrawsOnCanvasesOfAnySize) {
  PassStudio& studio = PassStudio::Shared();
  for (const auto& [width, height] : {std::pair{1, 1}, {17, 9}, {301, 40}, {40, 301}}) {
    const Picture picture = studio.Draw(PlainScene(Style::kSoft), width, height);
    EXPECT_GT(picture.bytes[1], 0) << width << " x " << height;
  }
}

// Room for the light on skin is made for the largest canvas, and serves smaller ones.
TEST(Painter, DrawsFinelyOnASmallCanvasAfterALargeOneAsBefore) {
  PassStudio& studio = PassStudio::Shared();
  ASSERT_TRUE(studio.painter().SetQuality(passes::Quality::kFinest));
  const scene::Scene scene = PlainScene(Style::kSoft);
  const Picture before = studio.Draw(scene, 120, 90);
  const Picture large = studio.Draw(scene, 320, 300);
  const Picture after = studio.Draw(scene, 120, 90);
  ASSERT_TRUE(studio.painter().SetQuality(passes::Quality::kBasic));
  EXPECT_GT(large.bytes[1], 0);
  EXPECT_EQ(before.bytes, after.bytes);
}

TEST(Painter, AllocatesNothingForAThousandFrames) {
  PassStudio& studio = PassStudio::Shared();
  auto canvas = gl::Canvas::Make({.width_px = 16, .height_px = 12});
  ASSERT_TRUE(canvas) << canvas.error().message();
  scene::Scene scene = PlainScene(Style::kSoft);
  scene.weights.faces.Push(1, 0.5F);
  const auto draw = [&](int frame) {
    scene.styles = {};
    scene.styles[static_cast<std::size_t>(frame % scene::kStyleCount)] = 1;
    scene.head.yaw_rad = 0.001F * static_cast<float>(frame);
    studio.painter().Draw(scene, *canvas);
  };
  for (int frame = 0; frame < 20; ++frame) draw(frame);
  const std::size_t before = sim::AllocationCount();
  for (int frame = 0; frame < 1000; ++frame) draw(frame);
  EXPECT_EQ(sim::AllocationCount() - before, 0U);
}

}  // namespace
}  // namespace kaori
