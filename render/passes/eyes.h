// The eyeballs: solid balls in the head, their irises turned by the gaze, wet and shaded by the lids.
#pragma once

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/scene/scene.h"

namespace kaori::passes {

// Each ball is the front cap of a sphere, of which the lids leave less to be seen; one mesh of unit
// directions serves both eyes.
class EyesPass {
 public:
  // Borrows the topology, whose lid rings say where the lids' edges are. Errors: invalid_argument (a shader).
  static Result<EyesPass> Open(const face::Topology& topology);

  // `gaze`: the character's left, right, turned about the ball's centre with the head. Lids shade the ball
  // below them, by nine heights of each margin over it; a ball without a radius is left out. `pupil`:
  // Scene::pupil.
  void Draw(const face::Shape& shape, const std::array<scene::Gaze, 2>& gaze, float pupil) const;
  // Dark balls between the lids that only hide what lies behind them, for the wireframe.
  void DrawDark(const face::Shape& shape) const;

 private:
  EyesPass(gl::Program program, gl::Program dark, const face::Topology& topology);

  // Borrowed.
  const face::Topology* topology_;
  // The eye as it is seen, and a dark ball for the wireframe.
  gl::Program program_;
  gl::Program dark_;
  // Where uniforms are, of program_ and then of dark_.
  int ball_, gaze_, lid_, iris_, white_, drawn_, answer_, dark_ball_, dark_lid_;
  // Unit directions from the ball's centre; cap_ borrows them.
  gl::Buffer directions_;
  gl::Mesh cap_;
};

}  // namespace kaori::passes
