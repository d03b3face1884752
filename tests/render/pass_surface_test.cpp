// The surface of a face in the drawing's memory.
#include "render/passes/surface.h"

#include <gtest/gtest.h>

#include <vector>

#include "render/gl/canvas.h"
#include "tests/render/pass_studio.h"

namespace kaori::tests {
namespace {

std::vector<std::uint8_t> PictureOf(const face::Cast& cast) {
  const auto painter = passes::Painter::Open(PassStudio::Shared().context(), cast);
  const auto canvas = gl::Canvas::Make({.width_px = 96, .height_px = 96});
  if (!painter || !canvas) return {};
  (*painter)->Draw(PlainScene(scene::Style::kSoft), *canvas);
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

}  // namespace
}  // namespace kaori::tests
