// Teeth and tongue, behind the lips: shared by all faces, fitted to each, moved by the jaw.
#pragma once

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/program.h"
#include "render/passes/prop_mesh.h"

namespace kaori::passes {

// Props of the parts upper teeth, lower teeth and tongue, each fitted by a scale, an offset and the jaw's
// motion in the shader.
class MouthPass {
 public:
  // Copies the mouth's anchor; borrows nothing. Errors: invalid_argument (a shader).
  static Result<MouthPass> Open(const face::Cast& cast);

  // Draws nothing while the lips touch. The lower teeth follow the jaw, the tongue nearly so; what the face
  // hides (MouthFit) shrinks and darkens.
  void Draw(const Appearance& appearance, const face::Shape& shape) const;

 private:
  // One prop, in the program that Draw has set.
  void DrawPart(const PropMesh& prop, float presence, const face::Shape& shape) const;

  gl::Program program_;
  glm::vec3 anchor_{};
  int fit_ = -1, anchor_at_ = -1, paint_ = -1, look_ = -1;
};

}  // namespace kaori::passes
