#include "render/passes/clothes.h"

#include "render/gl/draw_state.h"

namespace kaori::passes {

Result<ClothesPass::Variant> ClothesPass::MakeVariant(std::string defines) {
  auto program = MakeProgram("clothes.vert", "clothes.frag", std::move(defines));
  if (!program) return tl::unexpected(program.error());
  Variant v;
  v.paint = program->Find("paint");
  v.fit = program->Find("fit");
  v.collar = program->Find("collar_px");
  v.shrinks_from = program->Find("shrinks_from");
  v.shrinks_to = program->Find("shrinks_to");
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
  gl::Program::Set(variant.collar, HeightInPicture_px(frame, {0, dressing.collar_m, 0}, Follows::kBody));
  gl::Program::Set(variant.shrinks_from, glm::vec4(dressing.shrinks_from, dressing.share));
  gl::Program::Set(variant.shrinks_to, dressing.shrinks_to);
  for (const WornGarments& worn : dressing.worn()) {
    gl::Program::Set(variant.fit, glm::vec4(worn.from, worn.to, worn.rise_m, worn.widen_m));
    DrawWorn(appearance, variant, worn.face);
  }
}

void ClothesPass::DrawWorn(const Appearance& appearance, const Variant& variant, std::size_t face) {
  for (const int index : appearance.worn_by(face)) {
    const PropMesh& prop = appearance.meshes()[static_cast<std::size_t>(index)];
    if (prop.part != face::Part::kClothes) continue;
    gl::Program::Set(variant.paint, prop.paint);
    prop.mesh.Draw();
  }
}

}  // namespace kaori::passes
