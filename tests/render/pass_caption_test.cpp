// Captions in pictures: lines that are broken, a plate at the left below, and what stays of it.
#include <gtest/gtest.h>

#include <limits>

#include "tests/render/pass_studio.h"

namespace kaori {
namespace {

using scene::Style;
using tests::Difference;
using tests::PassStudio;
using tests::Picture;
using tests::PlainScene;

constexpr int kWidth_px = 480;
constexpr int kHeight_px = 270;

scene::Scene Captioned(std::vector<std::string> lines, float shown = 1) {
  scene::Scene scene = PlainScene(Style::kSoft);
  scene.backdrop = {.top = {0.2F, 0.2F, 0.2F}, .bottom = {0.2F, 0.2F, 0.2F}};
  scene.caption = {.shown = shown, .lines = std::move(lines)};
  return scene;
}

Picture Draw(const scene::Scene& scene) {
  return PassStudio::Shared().Draw(scene, kWidth_px, kHeight_px);
}

// Of the part of the picture right of and above a place, how much differs at most.
int FarthestBeyond(const Picture& a, const Picture& b, int x_px, int y_px) {
  int farthest = 0;
  for (int y = 0; y < a.height_px; ++y) {
    for (int x = 0; x < a.width_px; ++x) {
      if (x < x_px && y < y_px) continue;
      for (int c = 0; c < 3; ++c) farthest = std::max(farthest, std::abs(int{a.at(x, y)[c]} - b.at(x, y)[c]));
    }
  }
  return farthest;
}

TEST(Caption, StandsAtTheLeftBelowAndNowhereElse) {
  const Picture bare = Draw(Captioned({}));
  const Picture picture = Draw(Captioned({"handle MC.l", "expression: Smile"}));
  EXPECT_GT(Difference(picture, bare), 1);
  EXPECT_EQ(FarthestBeyond(picture, bare, kWidth_px * 2 / 5, kHeight_px / 4), 0);
}

TEST(Caption, IsLightOnADarkPlate) {
  const Picture bare = Draw(Captioned({}));
  const Picture picture = Draw(Captioned({"HHHHHHHH"}));
  int lighter = 0;
  int darker = 0;
  for (std::size_t i = 0; i < picture.bytes.size(); i += 4) {
    lighter += picture.bytes[i] > bare.bytes[i] + 60 ? 1 : 0;
    darker += picture.bytes[i] + 30 < bare.bytes[i] ? 1 : 0;
  }
  EXPECT_GT(lighter, 50);
  EXPECT_GT(darker, 3 * lighter);
}

TEST(Caption, SaysSomethingElseWhenItsLinesChange) {
  const Picture a = Draw(Captioned({"mirror on"}));
  const Picture b = Draw(Captioned({"mirror off"}));
  EXPECT_NE(a.bytes, b.bytes);
  EXPECT_EQ(Draw(Captioned({"mirror on"})).bytes, a.bytes);
}

TEST(Caption, FadesWithWhatIsShownOfIt) {
  const Picture bare = Draw(Captioned({}));
  double seen = 0;
  for (const float shown : {0.25F, 0.5F, 1.0F}) {
    const double now = Difference(Draw(Captioned({"expression: Smile"}, shown)), bare);
    EXPECT_GT(now, seen) << shown;
    seen = now;
  }
  EXPECT_EQ(Draw(Captioned({"expression: Smile"}, 0)).bytes, bare.bytes);
  EXPECT_EQ(Draw(Captioned({"expression: Smile"}, std::numeric_limits<float>::quiet_NaN())).bytes,
            bare.bytes);
}

TEST(Caption, LeavesNoTraceOnACanvas) {
  PassStudio& studio = PassStudio::Shared();
  const auto canvas = gl::Canvas::Make({.width_px = kWidth_px, .height_px = kHeight_px});
  ASSERT_TRUE(canvas) << canvas.error().message();
  for (const char* line : {"a long line that is there", "a", "", "a"}) {
    const scene::Scene scene = Captioned({line, line});
    for (int frame = 0; frame < 3; ++frame)
      ASSERT_EQ(studio.DrawOn(*canvas, scene).bytes, Draw(scene).bytes) << line << frame;
  }
  const scene::Scene none = Captioned({"a"}, 0);
  for (int frame = 0; frame < 2; ++frame) ASSERT_EQ(studio.DrawOn(*canvas, none).bytes, Draw(none).bytes);
}

TEST(Caption, OfTooManyLinesTheFirstAreKept) {
  std::vector<std::string> lines(30, "help");
  lines[0] = "handle MC.l";
  const Picture picture = Draw(Captioned(lines));
  lines[29] = "another end";
  EXPECT_EQ(Draw(Captioned(lines)).bytes, picture.bytes);
  lines[0] = "handle UC";
  EXPECT_NE(Draw(Captioned(lines)).bytes, picture.bytes);
}

TEST(Caption, FitsOnCanvasesOfAnySize) {
  const std::vector<std::string> lines(40, "Zum Lächeln gehören zwei Mundwinkel und 笑顔");
  for (const auto& [width, height] : {std::pair{1, 1}, {17, 9}, {301, 40}, {40, 301}, {1920, 1080}}) {
    const Picture picture = PassStudio::Shared().Draw(Captioned(lines), width, height);
    EXPECT_EQ(picture.width_px, width);
  }
}

}  // namespace
}  // namespace kaori
