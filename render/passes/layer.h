// Lays what was drawn on the picture: over its backdrop, and over the layers before it, by its opacity.
#pragma once

#include <cstdint>

#include "render/gl/canvas.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/passes/figure_region.h"
#include "render/scene/scene.h"

namespace kaori::passes {

class LayerPass {
 public:
  // Errors: invalid_argument (a shader).
  static Result<LayerPass> Open();

  struct Laying {
    float opacity = 1;   // 1 replaces what is there.
    float print = 0;     // 0..1: how much of the figure is a poster's print.
    float exposure = 1;  // Of the light on the figure.
  };
  // The canvas's layer, where the figure is.
  void Lay(const gl::Canvas& canvas, const FigureRegion& figure, const scene::Backdrop& backdrop,
           const Laying& laying) const;
  // The backdrop alone, everywhere but there. Called once a frame, before all layers: where it stands
  // already, from the last frame on this canvas, it is left alone.
  void LayBackdropAround(const gl::Canvas& canvas, const FigureRegion& figure,
                         const scene::Backdrop& backdrop);

 private:
  void Fill(const gl::Canvas& canvas, const gl::Box& box) const;
  // The backdrop stands on all of the canvas but `last_figure_`.
  bool Stands(const gl::Canvas& canvas, const scene::Backdrop& backdrop) const;

  struct Variant {
    gl::Program program;
    int top = -1;
    int bottom = -1;
    int opacity = -1;
    int print = -1;
    void Use(const scene::Backdrop& backdrop, float opaque) const;
  };
  static Variant Named(gl::Program program);

  Variant plain_;  // Both read the layer's samples where the context can.
  Variant printed_;
  Variant backdrop_;
  gl::Mesh everywhere_;

  std::uint64_t frame_ = 0;
  scene::Backdrop last_backdrop_;
  FigureRegion last_figure_;
};

}  // namespace kaori::passes
