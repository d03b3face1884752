// ExpressionEditor in pictures: where they stand, what hides them, and what colour they have.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "render/passes/handles.h"
#include "render/scene/view.h"
#include "tests/render/allocation_count.h"
#include "tests/render/pass_studio.h"

namespace kaori {
namespace {

using scene::Style;
using testing::Difference;
using testing::PassStudio;
using testing::Picture;
using testing::PlainScene;

constexpr int kNeedlesWidth_px = 480;
constexpr int kNeedlesHeight_px = 360;

scene::Scene NeedleScene(Style style = Style::kFlat) {
  scene::Scene scene = PlainScene(style);
  scene.needles.shown = 1;
  return scene;
}

Picture NeedlesDraw(const scene::Scene& scene) {
  return PassStudio::Shared().Draw(scene, kNeedlesWidth_px, kNeedlesHeight_px);
}

glm::vec3 MeanAt(std::size_t point, std::span<const glm::vec3> of) {
  const face::SparseRows& rows = PassStudio::Shared().cast().net.surface;
  glm::vec3 sum{0};
  for (std::uint32_t k = rows.row_start[point]; k < rows.row_start[point + 1]; ++k)
    sum += rows.weight[k] * of[rows.column[k]];
  return sum;
}

// The control point that looks most at the camera, of the face that was drawn last.
int FrontPoint() {
  PassStudio& studio = PassStudio::Shared();
  int best = 0;
  float best_z = -1;
  for (std::size_t i = 0; i < studio.cast().net.points.size(); ++i) {
    const glm::vec3 normal = MeanAt(i, studio.painter().shape().cage_normals);
    if (normal.z <= best_z) continue;
    best_z = normal.z;
    best = static_cast<int>(i);
  }
  return best;
}

struct Spot {
  int x_px = 0;
  int y_px = 0;
};

Spot PlaceOf(int point, const scene::Scene& scene) {
  PassStudio& studio = PassStudio::Shared();
  const float aspect = static_cast<float>(kNeedlesWidth_px) / static_cast<float>(kNeedlesHeight_px);
  const scene::View view(scene, studio.cast().neck_pivot, aspect);
  const glm::vec2 at = view.InPicture(MeanAt(static_cast<std::size_t>(point), studio.painter().shape().cage));
  return {static_cast<int>((at.x * 0.5F + 0.5F) * kNeedlesWidth_px),
          static_cast<int>((at.y * 0.5F + 0.5F) * kNeedlesHeight_px)};
}

// How warm the warmest pixel near a place is: red over blue.
int WarmestNear(const Picture& picture, Spot spot) {
  int warmest = -255;
  for (int y = spot.y_px - 14; y <= spot.y_px + 14; ++y) {
    for (int x = spot.x_px - 14; x <= spot.x_px + 14; ++x) {
      if (x < 0 || y < 0 || x >= picture.width_px || y >= picture.height_px) continue;
      const std::uint8_t* p = picture.at(x, y);
      warmest = std::max(warmest, int{p[0]} - int{p[2]});
    }
  }
  return warmest;
}

TEST(ExpressionEditor, AreNotThereWhenNoneAreShown) {
  scene::Scene scene = PlainScene(Style::kSoft);
  const Picture bare = NeedlesDraw(scene);
  scene.needles.chosen = 3;
  scene.needles.pulls_m = {0.01F, 0.02F};
  EXPECT_EQ(NeedlesDraw(scene).bytes, bare.bytes);
  EXPECT_EQ(passes::HandlesPass::ReachOf(scene.needles), 0) << "and ask for no room";
}

TEST(ExpressionEditor, StickInTheFaceInEveryStyle) {
  for (const Style style : {Style::kWire, Style::kFlat, Style::kBare, Style::kHair, Style::kSoft}) {
    EXPECT_GT(Difference(NeedlesDraw(NeedleScene(style)), NeedlesDraw(PlainScene(style))), 0.02) << static_cast<int>(style);
  }
}

TEST(ExpressionEditor, GrowOutOfTheSkin) {
  const Picture bare = NeedlesDraw(PlainScene(Style::kFlat));
  double seen = 0;
  for (const float shown : {0.25F, 0.5F, 0.75F, 1.0F}) {
    scene::Scene scene = NeedleScene();
    scene.needles.shown = shown;
    const double more = Difference(NeedlesDraw(scene), bare);
    EXPECT_GT(more, seen) << shown;
    seen = more;
  }
}

TEST(ExpressionEditor, TheChosenOneIsWarmAndStandsAtItsControlPoint) {
  scene::Scene scene = NeedleScene();
  const Picture before = NeedlesDraw(scene);
  scene.needles.chosen = FrontPoint();
  const Spot spot = PlaceOf(scene.needles.chosen, scene);
  const Picture chosen = NeedlesDraw(scene);
  EXPECT_GT(WarmestNear(chosen, spot), 120);
  EXPECT_LT(WarmestNear(before, spot), 100);
}

TEST(ExpressionEditor, APartnerIsLighterThanTheChosenOne) {
  scene::Scene scene = NeedleScene();
  NeedlesDraw(scene);
  const int point = FrontPoint();
  const Spot spot = PlaceOf(point, scene);
  scene.needles.chosen = point;
  const int chosen = WarmestNear(NeedlesDraw(scene), spot);
  scene.needles.chosen = -1;
  scene.needles.partner = point;
  const int partner = WarmestNear(NeedlesDraw(scene), spot);
  scene.needles.partner = -1;
  const int plain = WarmestNear(NeedlesDraw(scene), spot);
  EXPECT_GT(chosen, partner);
  EXPECT_GT(partner, plain);
}

TEST(ExpressionEditor, PulledOnesAreWarmer) {
  scene::Scene scene = NeedleScene();
  NeedlesDraw(scene);
  const int point = FrontPoint();
  const Spot spot = PlaceOf(point, scene);
  int warmth = WarmestNear(NeedlesDraw(scene), spot);
  scene.needles.pulls_m.resize(PassStudio::Shared().cast().net.points.size());
  for (const float pull_m : {0.003F, 0.009F}) {
    scene.needles.pulls_m[static_cast<std::size_t>(point)] = pull_m;
    const int now = WarmestNear(NeedlesDraw(scene), spot);
    EXPECT_GT(now, warmth) << pull_m;
    warmth = now;
  }
}

TEST(ExpressionEditor, TheHeadHidesThoseBehindIt) {
  const double in_front = Difference(NeedlesDraw(NeedleScene()), NeedlesDraw(PlainScene(Style::kFlat)));
  scene::Scene behind = NeedleScene();
  behind.camera.yaw_rad = 3.14F;
  scene::Scene bare = PlainScene(Style::kFlat);
  bare.camera.yaw_rad = 3.14F;
  EXPECT_LT(Difference(NeedlesDraw(behind), NeedlesDraw(bare)), 0.2 * in_front);
}

TEST(ExpressionEditor, TheChosenOneGlimmersThroughWhatHidesIt) {
  scene::Scene behind = NeedleScene();
  NeedlesDraw(behind);
  const int point = FrontPoint();
  behind.camera.yaw_rad = 3.14F;
  const Picture without = NeedlesDraw(behind);
  behind.needles.chosen = point;
  const Spot spot = PlaceOf(point, behind);
  EXPECT_GT(WarmestNear(NeedlesDraw(behind), spot), WarmestNear(without, spot) + 20);
}

TEST(ExpressionEditor, LeaveNoTraceOnACanvas) {
  PassStudio& studio = PassStudio::Shared();
  const auto canvas = gl::Canvas::Make({.width_px = kNeedlesWidth_px, .height_px = kNeedlesHeight_px});
  ASSERT_TRUE(canvas) << canvas.error().message();
  for (const float shown : {1.0F, 0.3F, 0.0F, 1.0F}) {
    scene::Scene scene = NeedleScene(Style::kSoft);
    scene.needles.shown = shown;
    EXPECT_EQ(studio.DrawOn(*canvas, scene).bytes, NeedlesDraw(scene).bytes) << shown;
  }
}

TEST(ExpressionEditor, StayWithinTheRoomThatIsClearedForThem) {
  scene::Scene scene = NeedleScene();
  scene.needles.pulls_m.assign(PassStudio::Shared().cast().net.points.size(), 1.0F);
  PassStudio& studio = PassStudio::Shared();
  const auto canvas = gl::Canvas::Make({.width_px = kNeedlesWidth_px, .height_px = kNeedlesHeight_px});
  ASSERT_TRUE(canvas) << canvas.error().message();
  for (int n = 0; n < static_cast<int>(scene.needles.pulls_m.size()); n += 7) {
    scene.needles.chosen = n;
    ASSERT_EQ(studio.DrawOn(*canvas, scene).bytes, NeedlesDraw(scene).bytes) << n;
  }
}

TEST(ExpressionEditor, SurviveNumbersThatAreNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Picture good = NeedlesDraw(NeedleScene());
  scene::Scene scene = NeedleScene();
  scene.needles.chosen = 1'000'000;
  scene.needles.partner = -7;
  scene.needles.pulls_m = {nan, -1, std::numeric_limits<float>::infinity()};
  EXPECT_LT(Difference(NeedlesDraw(scene), good), 0.1);
  scene.needles.shown = nan;
  EXPECT_EQ(NeedlesDraw(scene).bytes, NeedlesDraw(PlainScene(Style::kFlat)).bytes);
}

TEST(ExpressionEditor, TakeNothingFromTheHeap) {
  PassStudio& studio = PassStudio::Shared();
  const auto canvas = gl::Canvas::Make({.width_px = 16, .height_px = 12});
  ASSERT_TRUE(canvas) << canvas.error().message();
  scene::Scene scene = NeedleScene(Style::kSoft);
  scene.needles.pulls_m.resize(studio.cast().net.points.size());
  scene.needles.chosen = 1;
  scene.caption = {.shown = 1,
                   .lines = {"needle MC.l   u +2.4   mirror on   smooth on", "expression: Smile"}};
  for (int frame = 0; frame < 20; ++frame) studio.painter().Draw(scene, *canvas);
  const std::size_t before = testing::AllocationCount();
  for (int frame = 0; frame < 200; ++frame) {
    scene.needles.chosen = frame % 3;
    studio.painter().Draw(scene, *canvas);
  }
  EXPECT_EQ(testing::AllocationCount() - before, 0U);
}

}  // namespace
}  // namespace kaori
