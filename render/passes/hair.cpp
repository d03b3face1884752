#include "render/passes/hair.h"

#include "render/gl/draw_state.h"
#include "render/passes/frame.h"

namespace kaori::passes {
namespace {

// The band of light is the hair's own colour and a little of the lamp's.
constexpr glm::vec3 kGleam{0.16F, 0.10F, 0.065F};

// Hair below this share is not drawn, and above kWhole it is drawn without growth, which is cheaper.
constexpr float kHairGone = 0.01F;
constexpr float kWhole = 0.999F;

}  // namespace

Result<HairPass::Variant> HairPass::MakeVariant(std::string defines) {
  auto program = MakeProgram("hair.vert", "hair.frag", std::move(defines));
  if (!program) return tl::unexpected(program.error());
  Variant v;
  v.paint = program->Find("paint");
  v.gleam = program->Find("gleam");
  v.grown = program->Find("grown");
  v.program = std::move(*program);
  return v;
}

Result<HairPass> HairPass::Open() {
  auto whole = MakeVariant("");
  if (!whole) return tl::unexpected(whole.error());
  auto growing = MakeVariant("#define GROWTH\n");
  if (!growing) return tl::unexpected(growing.error());
  HairPass pass;
  pass.whole_ = std::move(*whole);
  pass.growing_ = std::move(*growing);
  return pass;
}

// Every prop of hair by itself: each has its own presence while faces cross-fade.
void HairPass::Draw(const Appearance& appearance, float share) const {
  for (std::size_t i = 0; i < appearance.meshes().size(); ++i) {
    const PropMesh& prop = appearance.meshes()[i];
    const float presence = appearance.presence(i) * share;
    if (prop.part == face::Part::kHair && presence > kHairGone) DrawLocks(prop, presence);
  }
}

void HairPass::DrawLocks(const PropMesh& hair, float presence) const {
  const bool whole = presence > kWhole;
  const Variant& variant = whole ? whole_ : growing_;
  gl::Apply({.blend = whole ? gl::Blend::kReplace : gl::Blend::kCoverage});
  variant.program.Use();
  gl::Program::Set(variant.paint, hair.paint);
  gl::Program::Set(variant.gleam, hair.paint * 3.2F + kGleam);
  // A little more than whole, so that the last tips are out before the variant without growth takes over.
  gl::Program::Set(variant.grown, presence * 1.2F);
  hair.mesh.Draw();
}

}  // namespace kaori::passes
