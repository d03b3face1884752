#include "render/passes/clothes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/gl/draw_state.h"

namespace kaori::passes {
namespace {

// As clothes.frag.
constexpr float kFlatArcs = 0.45F;
// Half of the widest shoulders.
constexpr float kShoulders_m = 0.19F;

// Where the collars sit on the layer, and how far the arcs reach from there to the farthest corner of
// clothes. Pixels.
glm::vec3 CollarOnLayer(const Dressing& dressing, const FrameBlock& frame) {
  const glm::vec2 half_px = 0.5F * glm::vec2(frame.sway.z, frame.sway.w);
  const glm::vec3 collar_m(0, dressing.collar_m - dressing.sinks_m, 0);
  const glm::vec2 collar_px = (1.0F + Project(frame, collar_m, Follows::kBody)) * half_px;
  const glm::vec2 shoulder_px =
      (1.0F + Project(frame, collar_m + glm::vec3(kShoulders_m, 0, 0), Follows::kBody)) * half_px;
  const glm::vec2 corner_px(kFlatArcs * (shoulder_px.x - collar_px.x), collar_px.y);
  return {collar_px, std::max(glm::length(corner_px), 1.0F)};
}

// The colour of a garment's part, by its place in the order in which the face wears them; of fewer parts the
// last one.
glm::vec3 OwnPaintAt(const Appearance& appearance, std::size_t face, std::size_t place) {
  glm::vec3 paint{};
  for (const int index : appearance.worn_by(face)) {
    const PropMesh& prop = appearance.meshes()[static_cast<std::size_t>(index)];
    if (prop.part != face::Part::kClothes) continue;
    paint = prop.paint;
    if (place-- == 0) break;
  }
  return paint;
}

// The same of all garments together, by their weights; of one face alone its own, to the last bit.
glm::vec3 PaintAt(const Appearance& appearance, const Dressing& dressing, std::size_t place) {
  glm::vec3 paint{};
  for (const WornGarments& worn : dressing.worn())
    paint += worn.weight * OwnPaintAt(appearance, worn.face, place);
  return paint;
}

// Two tables in one array: the shader looks both up at the same steps.
// As clothes.vert wants them: x what these clothes have, y what all have; behind the steps the half widths.
std::array<glm::vec4, Outline::kSamples + 1> Outlines(const Outline& own, const Outline& all) {
  std::array<glm::vec4, Outline::kSamples + 1> outlines{};
  for (std::size_t i = 0; i < Outline::kSamples; ++i)
    outlines[i] = {own.below_collar_m[i], all.below_collar_m[i], 0, 0};
  constexpr float kNoWidth_m = 1e-4F;
  outlines.back() = {std::max(own.half_width_m, kNoWidth_m), std::max(all.half_width_m, kNoWidth_m), 0, 0};
  return outlines;
}

}  // namespace

Result<ClothesPass::Variant> ClothesPass::MakeVariant(std::string defines) {
  auto program = MakeProgram("clothes.vert", "clothes.frag", std::move(defines));
  if (!program) return tl::unexpected(program.error());
  Variant v;
  v.paint = program->Find("paint");
  v.fit = program->Find("fit");
  v.outline = program->Find("outline");
  v.collar = program->Find("collar_px");
  v.neck = program->Find("neck");
  v.program = std::move(*program);
  return v;
}

Result<ClothesPass> ClothesPass::Open() {
  auto whole = MakeVariant("");
  if (!whole) return tl::unexpected(whole.error());
  auto changing = MakeVariant("#define CHANGING\n");
  if (!changing) return tl::unexpected(changing.error());
  ClothesPass pass;
  pass.whole_ = std::move(*whole);
  pass.changing_ = std::move(*changing);
  return pass;
}

void ClothesPass::Draw(const Appearance& appearance, const Dressing& dressing,
                       const FrameBlock& frame) const {
  const Variant& variant = dressing.whole() ? whole_ : changing_;
  gl::Apply({});
  variant.program.Use();
  gl::Program::Set(variant.collar, CollarOnLayer(dressing, frame));
  gl::Program::Set(variant.neck, glm::vec3(dressing.neck_m, dressing.sinks_m));
  for (const WornGarments& worn : dressing.worn()) {
    if (worn.from >= worn.to) continue;  // They lend their colour alone.
    gl::Program::Set(variant.fit, glm::vec4(worn.from, worn.to, worn.rise_m, worn.widen_m));
    const auto outlines = Outlines(worn.outline, dressing.outline);
    gl::Program::Set(variant.outline, std::span<const glm::vec4>(outlines));
    DrawWorn(appearance, variant, dressing, worn.face);
  }
}

// `place` counts the garments of this face alone, in the order in which it wears them: garments of several
// faces in the same place have one mixed paint.
void ClothesPass::DrawWorn(const Appearance& appearance, const Variant& variant, const Dressing& dressing,
                           std::size_t face) {
  std::size_t place = 0;
  for (const int index : appearance.worn_by(face)) {
    const PropMesh& prop = appearance.meshes()[static_cast<std::size_t>(index)];
    if (prop.part != face::Part::kClothes) continue;
    gl::Program::Set(variant.paint, PaintAt(appearance, dressing, place++));
    prop.mesh.Draw();
  }
}

}  // namespace kaori::passes
