// The wireframe: the cage's quad edges as smooth lines over a dark body that hides what lies behind.
#pragma once

#include <vector>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/gl/texture.h"
#include "render/passes/surface.h"
#include "render/scene/scene.h"

namespace kaori::passes {

class WirePass {
 public:
  // Errors: invalid_argument (a shader).
  static Result<WirePass> Open(const face::Cast& cast);

  // The surface's cage must be written. Each face's lines glow in a colour of its own; circles stand for iris
  // and pupil, turned by the gaze.
  void Draw(const Surface& surface, const face::Shape& shape, const std::array<scene::Gaze, 2>& gaze);

 private:
  WirePass(gl::Program body, gl::Program lines, const face::Cast& cast);
  void WritePoints(const face::Shape& shape, const std::array<scene::Gaze, 2>& gaze);
  glm::vec3 Paint(const face::Terms& faces) const;
  // `points`: where 2 circles of points go.
  void WriteEye(const face::EyeBall& ball, const scene::Gaze& gaze, float iris_m, glm::vec4* points) const;

  gl::Program body_;
  gl::Program lines_;
  int body_paint_, lines_paint_;
  // Of each face: what its lines glow in.
  std::vector<glm::vec3> glows_;
  std::size_t cage_points_;
  // The cage's, then two circles for each eye; w: brightness.
  std::vector<glm::vec4> points_;
  gl::Texture texture_;
  gl::Buffer corners_;
  gl::Mesh ribbons_;
};

}  // namespace kaori::passes
