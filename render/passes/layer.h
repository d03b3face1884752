// Lays what was drawn on the picture: over its backdrop, and over the layers before it, by its opacity.
#pragma once

#include <cstdint>

#include "render/gl/canvas.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/passes/figure_region.h"
#include "render/passes/frame.h"

namespace kaori::passes {

// The dots of a print go with the head: xy: its middle in the picture, pixels; zw: along a row of dots,
// radians of their wave for each pixel. `picture_px`: its width and height.
glm::vec4 DotsOn(const FrameBlock& frame, glm::vec2 picture_px);

// Reads each sample of the layer, squares it to light, and blends light: with samples averaged first, edges
// would be darker than they are. A larger layer is made smaller by the mean of what each pixel covers. Knows
// what the last frame left on a canvas (Canvas::Stamp), so that a backdrop at rest is not drawn again.
class LayerPass {
 public:
  // On a context that reads samples, shaders for GLES 3.1. Errors: invalid_argument (a shader).
  static Result<LayerPass> Open();

  // The backdrop: square roots of light, as large as the canvas (BackdropPass::picture). Borrowed for the
  // call.
  struct Behind {
    const gl::Texture& picture;
    // Differs when the picture does.
    std::uint64_t version = 0;
    // 0: dark.
    float dim = 1;
  };
  // How a layer is laid on what is there.
  struct Laying {
    // 1 replaces what is there.
    float opacity = 1;
    // 0..1: how much of the figure is a poster's print.
    float print = 0;
    // Of the light on the figure.
    float exposure = 1;
    // Of a print, as DotsOn says.
    glm::vec4 dots{0, 0, 1, 0};
  };
  // Lays the canvas's layer, where the figure is, over the backdrop, and the result over the layers before
  // it. The layer must have been drawn whole; it cannot be drawn on afterwards.
  void Lay(const gl::Canvas& canvas, const FigureRegion& figure, const Behind& behind,
           const Laying& laying) const;
  // The backdrop alone, everywhere but there. Called once a frame, before all layers: where it is in place
  // from the last frame on this canvas, only what the last figure covered is drawn. Sets the canvas's stamp.
  void LayBackdropAround(const gl::Canvas& canvas, const FigureRegion& figure, const Behind& behind);

 private:
  // Draws the program in use on this part of the picture.
  void Fill(const gl::Canvas& canvas, const gl::Box& box) const;
  // The backdrop is on all of the canvas but `last_figure_`, as the last frame left it.
  bool BackdropIsInPlace(const gl::Canvas& canvas, const Behind& behind) const;

  // A shader, and where its uniforms are.
  struct Variant {
    gl::Program program;
    int dim = -1;
    int opacity = -1;
    int per_pixel = -1;
    int print = -1;
    int dots = -1;
  };
  // Asks where the uniforms are.
  static Variant Named(gl::Program program);

  // Of the figure, as it is and as a poster's print.
  struct Pair {
    Variant plain;
    Variant printed;
  };
  static Result<Pair> MakePair(bool reads_samples);

  // Of layers with samples, where the context reads them, and of all others.
  Pair of_samples_;
  Pair of_texels_;
  Variant backdrop_;
  gl::Mesh everywhere_;

  // What the last call of LayBackdropAround left on the canvas of its stamp.
  std::uint64_t frame_ = 0;
  std::uint64_t last_version_ = 0;
  float last_dim_ = 0;
  FigureRegion last_figure_;
};

}  // namespace kaori::passes
