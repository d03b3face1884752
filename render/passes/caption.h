// A few lines of text at the left below, on a soft dark plate.
#pragma once

#include <string>
#include <vector>

#include "render/gl/canvas.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/gl/texture.h"
#include "render/image/text.h"
#include "render/scene/scene.h"

namespace kaori::passes {

// Letters are drawn by the processor (image::Lettering) into a texture, once for each text; a frame only
// lays that down.
class CaptionPass {
 public:
  // Errors: invalid_argument (a shader), not_enough_memory (the font).
  static Result<CaptionPass> Open();

  // Draws onto the picture, over all that is there, and clears the canvas's stamp: the picture is no longer
  // as the layers left it. Letters are as high as the canvas asks for; the plate keeps to the left of the
  // face; lines that are too long are broken, and of too many the last are left out. Letters are drawn, and
  // memory is taken, only when the lines or the size of the canvas change. Nothing where nothing is shown.
  void Draw(const scene::Caption& caption, const gl::Canvas& canvas);

 private:
  // All in pixels.
  struct Measures {
    // Size of the font.
    int letters = 0;
    // From line to line.
    int step = 0;
    // Of the plate about the letters.
    int border = 0;
    // From the plate to the edges of the picture.
    int margin = 0;
    // The longest line.
    int line_px = 0;
  };
  // All from the canvas's size.
  static Measures MeasuresFor(const gl::Canvas& canvas);
  // The lines as they are drawn, at most `most_px` high together.
  std::vector<std::string> Fitting(const Measures& m, int most_px);
  CaptionPass(gl::Program program, image::Lettering lettering);
  // Makes letters_ and the plate's box for these lines and this canvas.
  void WriteLetters(const std::vector<std::string>& lines, const gl::Canvas& canvas);

  gl::Program program_;
  image::Lettering lettering_;
  // Where uniforms of the program are.
  int plate_, border_, opacity_;
  gl::Mesh everywhere_;
  gl::Texture letters_;
  // As they stand in the texture.
  std::vector<std::string> lines_;
  int canvas_width_px_ = 0;
  int canvas_height_px_ = 0;
  // What letters_ and plate_box_ were made for.
  int border_px_ = 0;
  // Where the plate lies on the canvas; empty where there is no line.
  gl::Box plate_box_;
};

}  // namespace kaori::passes
