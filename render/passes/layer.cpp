#include "render/passes/layer.h"

#include "render/gl/context.h"
#include "render/gl/draw_state.h"
#include "render/passes/shader_library.h"

namespace kaori::passes {
namespace {

Result<gl::Program> Make(std::string_view fragment, bool reads_samples) {
  auto program = gl::Program::Make({.library = ShaderLibrary(),
                                    .vertex = "canvas.vert",
                                    .fragment = fragment,
                                    .defines = reads_samples ? "#define SAMPLES\n" : "",
                                    .reads_samples = reads_samples});
  if (program) program->BindSampler("layer", 0);
  return program;
}

}  // namespace

LayerPass::Variant LayerPass::Named(gl::Program program) {
  Variant v;
  v.top = program.Find("top");
  v.bottom = program.Find("bottom");
  v.opacity = program.Find("opacity");
  v.program = std::move(program);
  return v;
}

Result<LayerPass> LayerPass::Open() {
  auto backdrop = Make("backdrop.frag", false);
  if (!backdrop) return tl::unexpected(backdrop.error());
  auto resolved = Make("layer.frag", false);
  if (!resolved) return tl::unexpected(resolved.error());
  LayerPass pass;
  pass.backdrop_ = Named(std::move(*backdrop));
  pass.resolved_ = Named(std::move(*resolved));
  pass.everywhere_ = gl::Mesh({}, 3);
  if (!gl::Context::ReadsSamples()) return pass;
  auto samples = Make("layer.frag", true);
  if (!samples) return tl::unexpected(samples.error());
  pass.samples_ = Named(std::move(*samples));
  return pass;
}

void LayerPass::Variant::Use(const scene::Backdrop& backdrop, float opaque) const {
  program.Use();
  gl::Program::Set(top, backdrop.top);
  gl::Program::Set(bottom, backdrop.bottom);
  gl::Program::Set(opacity, opaque);
}

void LayerPass::Fill(const gl::Canvas& canvas, const gl::Box& box) const {
  if (box.empty()) return;
  canvas.BeginPicture(box);
  everywhere_.Draw();
}

void LayerPass::Lay(const gl::Canvas& canvas, const FigureRegion& figure, const scene::Backdrop& backdrop,
                    float opacity) const {
  if (figure.whole.empty()) return;
  canvas.BindLayer(0, figure.whole);
  const bool replaces = opacity >= 1;
  gl::Apply({.depth = gl::Depth::kOff, .blend = replaces ? gl::Blend::kReplace : gl::Blend::kOver});
  (canvas.layer_has_samples() ? samples_ : resolved_).Use(backdrop, opacity);
  for (const gl::Box& band : figure.bands) Fill(canvas, band);
}

void LayerPass::LayBackdropAround(const gl::Canvas& canvas, const FigureRegion& figure,
                                  const scene::Backdrop& backdrop) const {
  gl::Apply({.depth = gl::Depth::kOff});
  backdrop_.Use(backdrop, 1);
  for (const gl::Box& band : figure.bands) {
    const int left_px = band.empty() ? canvas.width_px() : band.left_px;
    const int right_px = band.empty() ? canvas.width_px() : band.left_px + band.width_px;
    Fill(canvas, {0, band.bottom_px, left_px, band.height_px});
    Fill(canvas, {right_px, band.bottom_px, canvas.width_px() - right_px, band.height_px});
  }
}

}  // namespace kaori::passes
