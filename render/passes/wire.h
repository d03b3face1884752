// The wireframe: the cage's quad edges as smooth lines over a dark body that hides what lies behind.
#pragma once

#include <array>
#include <vector>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/gl/texture.h"
#include "render/passes/surface.h"
#include "render/scene/scene.h"

namespace kaori::passes {

// Two draws: the dark body, pushed back a little, then the lines as ribbons that face the viewer, tested
// against its depth.
class WirePass {
 public:
  // Copies the wires and the faces' colours; borrows nothing. Errors: invalid_argument (a shader).
  static Result<WirePass> Open(const face::Cast& cast);

  // The surface's cage must be written. Each face's lines glow in a colour of its own; circles stand for iris
  // and pupil, turned by the gaze, as far as the lids leave them to be seen.
  void Draw(const Surface& surface, const face::Shape& shape, const std::array<scene::Gaze, 2>& gaze);

 private:
  WirePass(gl::Program body, gl::Program lines, const face::Cast& cast);
  // Fills points_ and the texture.
  void WritePoints(const face::Shape& shape, const std::array<scene::Gaze, 2>& gaze);
  // The colour of the lines.
  glm::vec3 Paint(const face::Terms& faces) const;
  // Writes 2 circles of points from `points` on, of the eye on this side.
  void WriteEye(const face::Shape& shape, std::size_t side, const scene::Gaze& gaze, glm::vec4* points) const;

  // The dark body, and the lines.
  gl::Program body_;
  gl::Program lines_;
  int body_paint_, lines_paint_;
  // Of each face: what its lines glow in.
  std::vector<glm::vec3> glows_;
  // The lids that cover the circles.
  std::array<face::LidRig, 2> lids_;
  // How many points of the cage come before those of the circles.
  std::size_t cage_points_;
  // Of each vertex of the cage: how much of its lines is seen.
  std::vector<float> fades_;
  // The cage's, then two circles for each eye; w: brightness.
  std::vector<glm::vec4> points_;
  gl::Texture texture_;
  gl::Buffer corners_;
  gl::Mesh ribbons_;
};

}  // namespace kaori::passes
