// The editor's handles in pictures: where they stand, what hides them, and what colour they have.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "hw-sim/evening/allocations.h"
#include "render/passes/handles.h"
#include "render/scene/view.h"
#include "tests/render/pass_studio.h"

namespace kaori {
namespace {

using scene::Style;
using tests::Difference;
using tests::PassStudio;
using tests::Picture;
using tests::PlainScene;

constexpr int kHandlesWidth_px = 480;
constexpr int kHandlesHeight_px = 360;

scene::Scene HandleScene(Style style = Style::kFlat) {
  scene::Scene scene = PlainScene(style);
  scene.handles.shown = 1;
  return scene;
}

Picture DrawHandles(const scene::Scene& scene) {
  return PassStudio::Shared().Draw(scene, kHandlesWidth_px, kHandlesHeight_px);
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
  const float aspect = static_cast<float>(kHandlesWidth_px) / static_cast<float>(kHandlesHeight_px);
  const scene::View view(scene, studio.cast().neck_pivot, aspect);
  const glm::vec2 at = view.InPicture(MeanAt(static_cast<std::size_t>(point), studio.painter().shape().cage));
  return {static_cast<int>((at.x * 0.5F + 0.5F) * kHandlesWidth_px),
          static_cast<int>((at.y * 0.5F + 0.5F) * kHandlesHeight_px)};
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

TEST(Handles, AreNotThereWhenNoneAreShown) {
  scene::Scene scene = PlainScene(Style::kSoft);
  const Picture bare = DrawHandles(scene);
  scene.handles.chosen = 3;
  scene.handles.pulls_m = {0.01F, 0.02F};
  EXPECT_EQ(DrawHandles(scene).bytes, bare.bytes);
  EXPECT_EQ(passes::HandlesPass::ReachOf(scene.handles), 0) << "and ask for no space";
}

TEST(Handles, StickInTheFaceInEveryStyle) {
  for (const Style style : {Style::kWire, Style::kFlat, Style::kBare, Style::kHair, Style::kSoft}) {
    EXPECT_GT(Difference(DrawHandles(HandleScene(style)), DrawHandles(PlainScene(style))), 0.02)
        << static_cast<int>(style);
  }
}

TEST(Handles, GrowOutOfTheSkin) {
  const Picture bare = DrawHandles(PlainScene(Style::kFlat));
  double seen = 0;
  for (const float shown : {0.25F, 0.5F, 0.75F, 1.0F}) {
    scene::Scene scene = HandleScene();
    scene.handles.shown = shown;
    const double more = Difference(DrawHandles(scene), bare);
    EXPECT_GT(more, seen) << shown;
    seen = more;
  }
}

TEST(Handles, TheChosenOneIsWarmAndStandsAtItsControlPoint) {
  scene::Scene scene = HandleScene();
  const Picture before = DrawHandles(scene);
  scene.handles.chosen = FrontPoint();
  const Spot spot = PlaceOf(scene.handles.chosen, scene);
  const Picture chosen = DrawHandles(scene);
  EXPECT_GT(WarmestNear(chosen, spot), 120);
  EXPECT_LT(WarmestNear(before, spot), 100);
}

TEST(Handles, APartnerIsLighterThanTheChosenOne) {
  scene::Scene scene = HandleScene();
  DrawHandles(scene);
  const int point = FrontPoint();
  const Spot spot = PlaceOf(point, scene);
  scene.handles.chosen = point;
  const int chosen = WarmestNear(DrawHandles(scene), spot);
  scene.handles.chosen = -1;
  scene.handles.partner = point;
  const int partner = WarmestNear(DrawHandles(scene), spot);
  scene.handles.partner = -1;
  const int plain = WarmestNear(DrawHandles(scene), spot);
  EXPECT_GT(chosen, partner);
  EXPECT_GT(partner, plain);
}

TEST(Handles, PulledOnesAreWarmer) {
  scene::Scene scene = HandleScene();
  DrawHandles(scene);
  const int point = FrontPoint();
  const Spot spot = PlaceOf(point, scene);
  int warmth = WarmestNear(DrawHandles(scene), spot);
  scene.handles.pulls_m.resize(PassStudio::Shared().cast().net.points.size());
  for (const float pull_m : {0.003F, 0.009F}) {
    scene.handles.pulls_m[static_cast<std::size_t>(point)] = pull_m;
    const int now = WarmestNear(DrawHandles(scene), spot);
    EXPECT_GT(now, warmth) << pull_m;
    warmth = now;
  }
}

TEST(Handles, TheHeadHidesThoseBehindIt) {
  const double in_front = Difference(DrawHandles(HandleScene()), DrawHandles(PlainScene(Style::kFlat)));
  scene::Scene behind = HandleScene();
  behind.camera.yaw_rad = 3.14F;
  scene::Scene bare = PlainScene(Style::kFlat);
  bare.camera.yaw_rad = 3.14F;
  EXPECT_LT(Difference(DrawHandles(behind), DrawHandles(bare)), 0.2 * in_front);
}

TEST(Handles, TheChosenOneGlimmersThroughWhatHidesIt) {
  scene::Scene behind = HandleScene();
  DrawHandles(behind);
  const int point = FrontPoint();
  behind.camera.yaw_rad = 3.14F;
  const Picture without = DrawHandles(behind);
  behind.handles.chosen = point;
  const Spot spot = PlaceOf(point, behind);
  EXPECT_GT(WarmestNear(DrawHandles(behind), spot), WarmestNear(without, spot) + 20);
}

TEST(Handles, LeaveNoTraceOnACanvas) {
  PassStudio& studio = PassStudio::Shared();
  const auto canvas = gl::Canvas::Make({.width_px = kHandlesWidth_px, .height_px = kHandlesHeight_px});
  ASSERT_TRUE(canvas) << canvas.error().message();
  for (const float shown : {1.0F, 0.3F, 0.0F, 1.0F}) {
    scene::Scene scene = HandleScene(Style::kSoft);
    scene.handles.shown = shown;
    EXPECT_EQ(studio.DrawOn(*canvas, scene).bytes, DrawHandles(scene).bytes) << shown;
  }
}

TEST(Handles, StayWithinTheRegionThatIsClearedForThem) {
  scene::Scene scene = HandleScene();
  scene.handles.pulls_m.assign(PassStudio::Shared().cast().net.points.size(), 1.0F);
  PassStudio& studio = PassStudio::Shared();
  const auto canvas = gl::Canvas::Make({.width_px = kHandlesWidth_px, .height_px = kHandlesHeight_px});
  ASSERT_TRUE(canvas) << canvas.error().message();
  for (int n = 0; n < static_cast<int>(scene.handles.pulls_m.size()); n += 7) {
    scene.handles.chosen = n;
    ASSERT_EQ(studio.DrawOn(*canvas, scene).bytes, DrawHandles(scene).bytes) << n;
  }
}

TEST(Handles, SurviveNumbersThatAreNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Picture good = DrawHandles(HandleScene());
  scene::Scene scene = HandleScene();
  scene.handles.chosen = 1'000'000;
  scene.handles.partner = -7;
  scene.handles.pulls_m = {nan, -1, std::numeric_limits<float>::infinity()};
  EXPECT_LT(Difference(DrawHandles(scene), good), 0.1);
  scene.handles.shown = nan;
  EXPECT_EQ(DrawHandles(scene).bytes, DrawHandles(PlainScene(Style::kFlat)).bytes);
}

TEST(Handles, AllocateNothing) {
  PassStudio& studio = PassStudio::Shared();
  const auto canvas = gl::Canvas::Make({.width_px = 16, .height_px = 12});
  ASSERT_TRUE(canvas) << canvas.error().message();
  scene::Scene scene = HandleScene(Style::kSoft);
  scene.handles.pulls_m.resize(studio.cast().net.points.size());
  scene.handles.chosen = 1;
  scene.caption = {.shown = 1,
                   .lines = {"handle MC.l   u +2.4   mirror on   smooth on", "expression: Smile"}};
  for (int frame = 0; frame < 20; ++frame) studio.painter().Draw(scene, *canvas);
  const std::size_t before = sim::AllocationCount();
  for (int frame = 0; frame < 200; ++frame) {
    scene.handles.chosen = frame % 3;
    studio.painter().Draw(scene, *canvas);
  }
  EXPECT_EQ(sim::AllocationCount() - before, 0U);
}

}  // namespace
}  // namespace kaori
