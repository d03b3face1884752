// Draws a canvas's picture on a screen's window, bit by bit: the codes of sRGB pass as they are
// (GL_EXT_texture_sRGB_decode). A blit does the same, but a software renderer compiles shaders for it anew at
// each start, and keeps ours.
#pragma once

#include "render/gl/canvas.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"

namespace kaori::passes {

// Used where a screen is drawn to by GL; other screens get their pixels by ReadPixels.
class ScreenPass {
 public:
  // Errors: not_supported (the driver decodes all sRGB texels that it reads), invalid_argument (a shader).
  static Result<ScreenPass> Open();

  // On the current window (gl::Window::Begin), which has the canvas's size. Fills all of it.
  void Draw(const gl::Canvas& canvas) const;

 private:
  gl::Program program_;
  gl::Mesh everywhere_;
};

}  // namespace kaori::passes
