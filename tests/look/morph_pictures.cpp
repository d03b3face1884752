#include "tests/look/morph_pictures.h"

#include <cstdlib>

#include "drivers/base/log.h"
#include "tests/look/look_pack.h"

namespace kaori::tests {
namespace {

// Of the backdrop's code, 255: what lets less of it through covers it.
constexpr int kSeenThrough = 240;
constexpr float kTurned_rad = 0.3F;

template <class T>
T Opened(Result<T> made) {
  if (made) return std::move(*made);
  Log("{}", made.error().message());
  std::abort();
}

}  // namespace

MorphPictures::MorphPictures()
    : haired_(std::make_unique<face::Cast>(HairyCast())),
      bald_(std::make_unique<face::Cast>(ClothedCast())),
      context_(Opened(gl::Context::Open())),
      canvas_(Opened(gl::Canvas::Make({.width_px = kWidth_px, .height_px = kHeight_px}))),
      with_hair_(Opened(passes::Painter::Open(*context_, *haired_))),
      without_(Opened(passes::Painter::Open(*context_, *bald_))) {}

MorphPictures::Bytes MorphPictures::Draw(passes::Painter& painter, const Morph& morph, glm::vec3 backdrop) {
  scene::Scene scene;
  scene.weights.faces.Push(morph.from, 1 - morph.share);
  scene.weights.faces.Push(morph.to, morph.share);
  scene.weights.expressions.Push(0, 1);
  scene.head.yaw_rad = kTurned_rad;
  scene.backdrop = {.top = backdrop, .bottom = backdrop, .glow = glm::vec3(0)};
  painter.Draw(scene, *canvas_);
  Bytes bytes(std::size_t{kWidth_px} * kHeight_px * 4);
  canvas_->ReadPixels(bytes);
  return bytes;
}

// A backdrop of pure green, and none: what differs by nearly all of it is not covered.
Pixels MorphPictures::Covered(passes::Painter& painter, const Morph& morph) {
  const Bytes bright = Draw(painter, morph, {0, 1, 0});
  const Bytes dark = Draw(painter, morph, {0, 0, 0});
  Pixels covered(bright.size() / 4);
  for (std::size_t i = 0; i < covered.size(); ++i)
    covered[i] = bright[4 * i + 1] - dark[4 * i + 1] < kSeenThrough;
  return covered;
}

}  // namespace kaori::tests
