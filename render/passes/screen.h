// Draws a canvas's picture on a screen's window, bit by bit: the codes of sRGB pass as they are
// (GL_EXT_texture_sRGB_decode). A blit does the same, but a software renderer compiles shaders for it anew at
// each start, and keeps ours. A backdrop at rest is not copied again.
#pragma once

#include <array>

#include "render/gl/canvas.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"

namespace kaori::passes {

// Used where a screen is drawn to by GL; other screens get their pixels by ReadPixels.
class ScreenPass {
 public:
  // Errors: not_supported (the driver decodes all sRGB texels that it reads), invalid_argument (a shader).
  static Result<ScreenPass> Open();

  // On the framebuffer that is bound (gl::Window::Begin), which has the canvas's size and holds the picture that
  // was drawn by so many calls ago, 1 the last one; 0: anything (gl::Window::PicturesAgo). Only what has changed
  // since is drawn, all where that is not known. Takes the canvas's damage; leaves the scissor test on.
  void Draw(const gl::Canvas& canvas, int pictures_ago);
  // What the last call drew is not to be counted on: it may not have been shown.
  void Forget() { known_ = 0; }

 private:
  // Screens swap two buffers or three; one more, for safety.
  static constexpr int kMostKnown = 4;

  gl::Program program_;
  gl::Mesh everywhere_;
  // What each of the last pictures changed, the newest first; so many are known.
  std::array<gl::Damage, kMostKnown> changes_{};
  int known_ = 0;
};

}  // namespace kaori::passes
