// The reference for F1: the default look's own meshes and shaders in a bare loop. Nothing is composed,
// nothing is written; one frame's buffers are drawn again and again, and read back.
#pragma once

#include <cstdint>
#include <span>

#include "render/face/composer.h"
#include "render/passes/backdrop.h"
#include "render/passes/body.h"
#include "render/passes/clothes.h"
#include "render/passes/eyes.h"
#include "render/passes/figure_region.h"
#include "render/passes/hair.h"
#include "render/passes/layer.h"
#include "render/passes/surface.h"

namespace kaori::benchmark {

class BareDraw {
 public:
  // Borrows the cast; a context is current. Aborts with a line in the log where a shader fails.
  BareDraw(const face::Cast& cast, const scene::Scene& scene, const gl::Canvas& canvas);

  void Draw(const gl::Canvas& canvas, std::span<std::uint8_t> bytes);

 private:
  face::Composer composer_;
  const face::Shape& shape_;
  scene::Scene scene_;
  passes::Appearance appearance_;
  passes::Surface surface_;
  passes::BodyPass body_;
  passes::EyesPass eyes_;
  passes::HairPass hair_;
  passes::ClothesPass clothes_;
  passes::Hairdo hairdo_;
  passes::Dressing dressing_;
  passes::BackdropPass backdrop_;
  passes::LayerPass layer_;
  passes::FrameBlock block_{};
  gl::Buffer frame_;
  passes::FigureRegion figure_;
};

}  // namespace kaori::benchmark
