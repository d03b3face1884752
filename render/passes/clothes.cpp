#include "render/passes/clothes.h"

#include <algorithm>

#include "render/gl/draw_state.h"
#include "render/passes/frame.h"

namespace kaori::passes {
namespace {

// Far enough to leave the picture.
constexpr float kSunk_m = 0.14F;
// A face with less weight than this dresses nobody: one step of 8 bits.
constexpr float kGone = 0.004F;

bool WearsClothes(const Appearance& appearance, std::size_t face) {
  return std::ranges::any_of(appearance.worn_by(face), [&](int prop) {
    return appearance.meshes()[static_cast<std::size_t>(prop)].part == face::Part::kClothes;
  });
}

// The part of the faces that wears anything.
float Dressed(const Appearance& appearance, const face::Terms& faces) {
  float dressed = 0;
  for (const face::Term& term : faces) dressed += WearsClothes(appearance, term.index) ? term.weight : 0.0F;
  return std::clamp(dressed, 0.0F, 1.0F);
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

// Each face's clothes over those before it, by its part of what is laid so far: the mean of all by their
// weights.
void ClothesPass::Draw(const Appearance& appearance, const face::Terms& faces) const {
  program_.Use();
  gl::Program::Set(sunk_, kSunk_m * (1 - Dressed(appearance, faces)));
  float laid = 0;
  for (const face::Term& term : faces) {
    if (term.weight < kGone || !WearsClothes(appearance, term.index)) continue;
    laid += term.weight;
    const bool first = laid <= term.weight;
    gl::Apply({.blend = first ? gl::Blend::kReplace : gl::Blend::kOver});
    gl::Program::Set(opacity_, term.weight / laid);
    DrawWorn(appearance, term.index);
  }
}

void ClothesPass::DrawWorn(const Appearance& appearance, std::size_t face) const {
  for (const int index : appearance.worn_by(face)) {
    const PropMesh& prop = appearance.meshes()[static_cast<std::size_t>(index)];
    if (prop.part != face::Part::kClothes) continue;
    gl::Program::Set(paint_, prop.paint);
    prop.mesh.Draw();
  }
}

}  // namespace kaori::passes
