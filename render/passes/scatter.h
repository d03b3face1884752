// Light within skin: what enters at one place comes out around it, red farthest, so that edges of shade are soft and
// warm. The skin's light is drawn apart, and spread along the picture's two axes, one after the other (Jimenez and
// others 2015, "Separable Subsurface Scattering"). Of the finest quality.
#pragma once

#include <optional>

#include "render/gl/box.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/gl/target.h"

namespace kaori::passes {

class ScatterPass {
 public:
  // Errors: invalid_argument (a shader).
  static Result<ScatterPass> Open();

  // Drawing goes to the skin's light from here on, in `figure`, a part of a picture as large as the canvas: linear light,
  // and in alpha the metres from the camera, more than 0. Room is made where a canvas is larger than those before it.
  // False where the driver has none, or does not draw on halves of floats: then nothing is to be drawn, and light stays
  // where it falls.
  bool Begin(int width_px, int height_px, const gl::Box& figure);

  // Spreads what was drawn since Begin. The frame's uniforms are bound; leaves them so.
  void Spread() const;

  // What came out, for shaders that read texture unit `unit` by texelFetch at their own pixel of the figure: as Begin says,
  // alpha 0 where there is no skin.
  void Bind(unsigned unit) const { light_->texture().Bind(unit); }

 private:
  // One axis, from one target into the other.
  void SpreadAlong(const gl::Target& from, const gl::Target& into, const glm::ivec2& axis) const;

  gl::Program program_;
  int axis_ = -1;
  int within_ = -1;
  gl::Mesh everywhere_;
  // As large as the largest canvas so far.
  std::optional<gl::Target> light_;
  std::optional<gl::Target> between_;
  // Of the canvas that is drawn.
  int width_px_ = 0;
  int height_px_ = 0;
  gl::Box figure_;
  // The driver has refused it once.
  bool refused_ = false;
};

}  // namespace kaori::passes
