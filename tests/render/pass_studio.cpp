#include "tests/render/pass_studio.h"

#include <cstdlib>

#include "drivers/base/log.h"

namespace kaori::tests {
namespace {

template <class T>
T Must(Result<T> made) {
  if (made) return std::move(*made);
  Log("{}", made.error().message());
  std::abort();
}

// The synthetic cast wears nothing: give it a block of hair, shoulders and a painted skin.
face::Prop Slab(face::Part part, glm::vec3 low, glm::vec3 high, glm::vec3 colour) {
  face::Prop prop;
  prop.part = part;
  prop.colour = colour;
  const glm::vec3 corners[] = {
      {low.x, low.y, high.z}, {high.x, low.y, high.z}, {high.x, high.y, high.z}, {low.x, high.y, high.z}};
  for (const glm::vec3& p : corners) {
    const float along = (high.y - p.y) / (high.y - low.y);
    prop.vertices.push_back({.position = p, .normal = {0, 0, 1}, .tangent = {0, -1, 0}, .along = along});
  }
  prop.triangles = {{0, 1, 2}, {0, 2, 3}};
  return prop;
}

face::Cast DressedCast() {
  face::Cast cast = MakeSyntheticCast({.columns = 24, .rows = 18, .faces = 2, .expressions = 3});
  cast.props = {Slab(face::Part::kHair, {-0.06F, 0.04F, 0}, {0.06F, 0.10F, 0.12F}, {0.05F, 0.02F, 0.01F}),
                Slab(face::Part::kClothes, {-0.15F, -0.3F, 0}, {0.15F, -0.12F, 0.1F}, {0.1F, 0.2F, 0.6F})};
  cast.textures = {{.width_px = 1, .height_px = 1, .rgba = {230, 190, 170, 0}},
                   {.width_px = 1, .height_px = 1, .rgba = {90, 60, 200, 0}}};
  for (std::size_t i = 0; i < cast.faces.size(); ++i) {
    cast.faces[i].surface.texture = static_cast<int>(i % 2);
    cast.faces[i].surface.flat = {0.6F, 0.5F, 0.4F};
  }
  cast.faces[0].props = {0, 1};
  return cast;
}

}  // namespace

double Difference(const Picture& a, const Picture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.bytes.size(); ++i) {
    if (i % 4 != 3) sum += std::abs(int{a.bytes[i]} - int{b.bytes[i]});
  }
  return sum / (static_cast<double>(a.bytes.size()) * 0.75);
}

PassStudio::PassStudio()
    : cast_(DressedCast()),
      context_(Must(gl::Context::Open())),
      painter_(Must(passes::Painter::Open(*context_, cast_))) {}

PassStudio& PassStudio::Shared() {
  static PassStudio studio;
  return studio;
}

Picture PassStudio::Draw(const scene::Scene& scene, int width_px, int height_px) {
  return DrawOn(Must(gl::Canvas::Make({.width_px = width_px, .height_px = height_px})), scene);
}

Picture PassStudio::DrawOn(const gl::Canvas& canvas, const scene::Scene& scene) {
  painter_->Draw(scene, canvas);
  Picture picture{canvas.width_px(), canvas.height_px(), {}};
  picture.bytes.resize(static_cast<std::size_t>(picture.width_px * picture.height_px * 4));
  canvas.ReadPixels(picture.bytes);
  return picture;
}

scene::Scene PlainScene(scene::Style style) {
  scene::Scene scene;
  scene.weights.faces.Push(0, 1);
  scene.weights.expressions.Push(0, 1);
  scene.styles = {};
  scene.styles[static_cast<std::size_t>(style)] = 1;
  return scene;
}

}  // namespace kaori::tests
