#include "render/passes/clothes.h"

#include "render/gl/draw_state.h"
#include "render/passes/frame.h"

namespace kaori::passes {
namespace {

// Far enough to leave the picture.
constexpr float kSunk_m = 0.14F;
constexpr float kGone = 0.004F;

float TotalPresence(const Wardrobe& wardrobe) {
  float total = 0;
  for (std::size_t i = 0; i < wardrobe.meshes().size(); ++i) {
    if (wardrobe.meshes()[i].part == face::Part::kClothes) total += wardrobe.presence(i);
  }
  return total;
}

}  // namespace

Result<ClothesPass> ClothesPass::Open() {
  auto program = MakeProgram("clothes.vert", "clothes.frag");
  if (!program) return tl::unexpected(program.error());
  ClothesPass pass;
  pass.paint_ = program->Find("paint");
  pass.sunk_ = program->Find("sunk_m");
  pass.opacity_ = program->Find("opacity");
  pass.program_ = std::move(*program);
  return pass;
}

void ClothesPass::Draw(const Wardrobe& wardrobe) const {
  const float total = TotalPresence(wardrobe);
  const float sunk_m = kSunk_m * (1 - glm::clamp(total, 0.0F, 1.0F));
  float laid = 0;
  program_.Use();
  gl::Program::Set(sunk_, sunk_m);
  for (std::size_t i = 0; i < wardrobe.meshes().size(); ++i) {
    const PropMesh& prop = wardrobe.meshes()[i];
    const float presence = wardrobe.presence(i);
    if (prop.part != face::Part::kClothes || presence < kGone) continue;
    laid += presence;
    gl::Apply({.cull = gl::Cull::kNone, .blend = laid > presence ? gl::Blend::kOver : gl::Blend::kReplace});
    gl::Program::Set(paint_, prop.paint);
    gl::Program::Set(opacity_, presence / laid);
    prop.mesh.Draw();
  }
}

}  // namespace kaori::passes
