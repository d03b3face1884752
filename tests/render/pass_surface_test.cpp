// The surface of a face in the drawing's memory.
#include "render/passes/surface.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <vector>

#include "render/gl/canvas.h"
#include "tests/render/pass_studio.h"

namespace kaori::tests {
namespace {

std::vector<std::uint8_t> PictureOf(const face::Cast& cast,
                                    const scene::Scene& scene = PlainScene(scene::Style::kSoft)) {
  const auto painter = passes::Painter::Open(PassStudio::Shared().context(), cast);
  const auto canvas = gl::Canvas::Make({.width_px = 96, .height_px = 96});
  if (!painter || !canvas) return {};
  (*painter)->Draw(scene, *canvas);
  std::vector<std::uint8_t> bytes(std::size_t{96} * 96 * 4);
  canvas->ReadPixels(bytes);
  return bytes;
}

TEST(Surface, OfAFaceWithoutOcclusionIsOpenEverywhere) {
  face::Cast cast = PassStudio::Shared().cast();
  for (face::Face& face : cast.faces) face.occlusion.clear();
  const auto without = PictureOf(cast);
  for (face::Face& face : cast.faces) face.occlusion.assign(cast.topology.vertex_count, 1.0F);
  ASSERT_FALSE(without.empty());
  EXPECT_EQ(without, PictureOf(cast));
}

TEST(Surface, ThatShowsAFlushIsAsRedAsTheExpressionAndNoDarkerInRed) {
  face::Cast cast = PassStudio::Shared().cast();
  scene::Scene scene = PlainScene(scene::Style::kSoft);
  scene.weights.expressions.clear();
  scene.weights.expressions.Push(1, 1);
  const auto sums = [&](float shown, float flush) {
    cast.faces[0].surface.flush = shown;
    cast.expressions[1].flush = flush;
    std::array<long, 3> total{};
    const auto picture = PictureOf(cast, scene);
    for (std::size_t i = 0; i < picture.size(); ++i)
      if (i % 4 < 3) total[i % 4] += picture[i];
    return total;
  };
  const auto pale = sums(0, 1), at_rest = sums(1, 0), half = sums(1, 0.5F), red = sums(1, 1);
  EXPECT_EQ(pale, at_rest);
  EXPECT_EQ(red[0], pale[0]);
  for (const std::size_t of : {1U, 2U}) {
    EXPECT_LT(red[of], half[of]);
    EXPECT_LT(half[of], pale[of]);
  }
}

// Five faces, each with a black skin of its own but for one, while four of them fade out and the last one was called.
std::vector<std::uint8_t> FadeWithWhite(std::size_t white) {
  face::Cast cast = PassStudio::Shared().cast();
  cast.faces.resize(5, cast.faces[0]);
  cast.textures.assign(5, {.width_px = 1, .height_px = 1, .rgba = {0, 0, 0, 0}});
  cast.textures[white].rgba = {255, 255, 255, 0};
  scene::Scene scene = PlainScene(scene::Style::kSoft);
  scene.weights.faces.clear();
  for (std::uint16_t i = 0; i < 5; ++i) {
    cast.faces[i].surface.texture = i;
    scene.weights.faces.Push(i, i == 4 ? 0.74F : 0.05F + 0.01F * static_cast<float>(i));
  }
  return PictureOf(cast, scene);
}

TEST(Body, OfFiveSkinsLeavesOutTheLightestAndNotTheOneThatWasCalled) {
  const auto light = [](const std::vector<std::uint8_t>& picture) {
    return std::accumulate(picture.begin(), picture.end(), 0L);
  };
  const auto without = FadeWithWhite(0), one_of_them = FadeWithWhite(3), called = FadeWithWhite(4);
  ASSERT_FALSE(without.empty());
  EXPECT_GT(light(one_of_them), light(without));
  EXPECT_GT(light(called), light(one_of_them) + 2 * (light(one_of_them) - light(without)));
}

}  // namespace
}  // namespace kaori::tests
