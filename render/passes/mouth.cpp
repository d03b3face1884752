#include "render/passes/mouth.h"

#include <algorithm>

#include "render/gl/draw_state.h"
#include "render/passes/frame.h"

namespace kaori::passes {
namespace {

// Lips that touch hide all; teeth would show between the triangles of the fine mesh.
constexpr float kShut_m = 0.0002F;
constexpr float kMouthGone = 0.02F;

// How much of a part the face shows; hair and clothes are no part of a mouth.
float FitPresence(const face::MouthFit& fit, face::Part part) {
  switch (part) {
    case face::Part::kUpperTeeth:
      return fit.upper_teeth;
    case face::Part::kLowerTeeth:
      return fit.lower_teeth;
    case face::Part::kTongue:
      return fit.tongue;
    default:
      return 0;
  }
}

// The lower teeth follow the jaw, down and back; the tongue nearly so.
glm::vec3 JawMotion(face::Part part, float drop_m) {
  switch (part) {
    case face::Part::kLowerTeeth:
      return {0, -drop_m, -0.25F * drop_m};
    case face::Part::kTongue:
      return {0, -0.80F * drop_m, -0.20F * drop_m};
    default:
      return {};
  }
}

// Shine of wet matter; teeth have a little of it too.
float WetShine(face::Part part) {
  return part == face::Part::kTongue ? 0.10F : 0.16F;
}

}  // namespace

Result<MouthPass> MouthPass::Open(const face::Cast& cast) {
  auto program = MakeProgram("mouth.vert", "mouth.frag");
  if (!program) return tl::unexpected(program.error());
  MouthPass pass;
  pass.program_ = std::move(*program);
  pass.anchor_ = cast.mouth_anchor;
  pass.fit_ = pass.program_.Find("fit");
  pass.anchor_at_ = pass.program_.Find("anchor");
  pass.paint_ = pass.program_.Find("paint");
  pass.look_ = pass.program_.Find("look");
  return pass;
}

// Both sides are drawn: an arch of teeth is open behind.
void MouthPass::Draw(const Appearance& appearance, const face::Shape& shape) const {
  if (shape.jaw_drop_m < kShut_m) return;
  gl::Apply({.cull = gl::Cull::kNone});
  program_.Use();
  gl::Program::Set(anchor_at_, anchor_);
  for (std::size_t i = 0; i < appearance.meshes().size(); ++i) {
    const PropMesh& prop = appearance.meshes()[i];
    const float presence = appearance.presence(i) * FitPresence(shape.mouth, prop.part);
    if (presence > kMouthGone) DrawPart(prop, presence, shape);
  }
}

// An open mouth is lit deeper.
void MouthPass::DrawPart(const PropMesh& prop, float presence, const face::Shape& shape) const {
  const glm::vec3 offset = shape.mouth.offset + JawMotion(prop.part, shape.jaw_drop_m);
  const float light = 0.45F + 0.55F * std::clamp(shape.jaw_drop_m / 0.010F, 0.0F, 1.0F);
  gl::Program::Set(fit_, glm::vec4(offset, shape.mouth.scale * (0.6F + 0.4F * presence)));
  gl::Program::Set(paint_, prop.paint);
  gl::Program::Set(look_, glm::vec2(WetShine(prop.part), light * presence));
  prop.mesh.Draw();
}

}  // namespace kaori::passes
