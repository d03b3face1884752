// The eyeballs: solid balls in the head, their irises turned by the gaze, wet and shaded by the lids.
#pragma once

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/scene/scene.h"

namespace kaori::passes {

class EyesPass {
 public:
  // Borrows the topology. Errors: invalid_argument (a shader).
  static Result<EyesPass> Open(const face::Topology& topology);

  // `gaze`: the character's left, right. Lids shade the ball below them; a ball without a radius is left out.
  void Draw(const face::Shape& shape, const std::array<scene::Gaze, 2>& gaze) const;
  // Dark balls that only hide what lies behind them, for the wireframe.
  void DrawDark(const face::Shape& shape) const;

 private:
  EyesPass(gl::Program program, gl::Program dark, const face::Topology& topology);

  const face::Topology* topology_;
  gl::Program program_;
  gl::Program dark_;
  int ball_, gaze_, lid_, iris_, dark_ball_;
  gl::Buffer directions_;
  gl::Mesh cap_;
};

}  // namespace kaori::passes
