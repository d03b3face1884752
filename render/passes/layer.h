// Lays what was drawn on the picture: over its backdrop, and over the layers before it, by its opacity.
#pragma once

#include "render/gl/canvas.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/scene/scene.h"

namespace kaori::passes {

class LayerPass {
 public:
  // Errors: invalid_argument (a shader).
  static Result<LayerPass> Open();

  // The canvas's layer within `box`. Opacity 1 replaces what is there.
  void Lay(const gl::Canvas& canvas, const gl::Box& box, const scene::Backdrop& backdrop,
           float opacity) const;
  // The backdrop alone, everywhere but in `box`.
  void LayBackdropAround(const gl::Canvas& canvas, const gl::Box& box, const scene::Backdrop& backdrop) const;

 private:
  struct Variant {
    gl::Program program;
    int top = -1;
    int bottom = -1;
    int opacity = -1;
    void Use(const scene::Backdrop& backdrop, float opaque) const;
  };
  static Variant Named(gl::Program program);

  Variant samples_;  // Reads the layer's samples; there where the context can.
  Variant resolved_;
  Variant backdrop_;
  gl::Mesh everywhere_;
};

}  // namespace kaori::passes
