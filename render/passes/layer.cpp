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

void LayerPass::Lay(const gl::Canvas& canvas, const gl::Box& box, const scene::Backdrop& backdrop,
                    float opacity) const {
  if (box.empty()) return;
  canvas.BindLayer(0, box);
  canvas.BeginPicture(box);
  const bool replaces = opacity >= 1;
  gl::Apply({.depth = gl::Depth::kOff, .blend = replaces ? gl::Blend::kReplace : gl::Blend::kOver});
  (canvas.layer_has_samples() ? samples_ : resolved_).Use(backdrop, opacity);
  everywhere_.Draw();
}

void LayerPass::LayBackdropAround(const gl::Canvas& canvas, const gl::Box& box,
                                  const scene::Backdrop& backdrop) const {
  const int width = canvas.width_px();
  const int top = box.bottom_px + box.height_px;
  const int right = box.left_px + box.width_px;
  const gl::Box around[] = {{0, 0, width, box.bottom_px},
                            {0, top, width, canvas.height_px() - top},
                            {0, box.bottom_px, box.left_px, box.height_px},
                            {right, box.bottom_px, width - right, box.height_px}};
  gl::Apply({.depth = gl::Depth::kOff});
  backdrop_.Use(backdrop, 1);
  for (const gl::Box& part : around) {
    if (part.empty()) continue;
    canvas.BeginPicture(part);
    everywhere_.Draw();
  }
}

}  // namespace kaori::passes
