#include "render/passes/scatter.h"

#include <algorithm>

#include "drivers/base/log.h"
#include "render/gl/draw_state.h"
#include "render/passes/frame.h"

namespace kaori::passes {

Result<ScatterPass> ScatterPass::Open() {
  auto program = MakeProgram("canvas.vert", "scatter.frag");
  if (!program) return tl::unexpected(program.error());
  ScatterPass pass;
  pass.program_ = std::move(*program);
  pass.program_.BindSampler("light", 0);
  pass.axis_ = pass.program_.Find("axis");
  pass.everywhere_ = gl::Mesh({}, 3);
  return pass;
}

bool ScatterPass::Begin(int width_px, int height_px) {
  if (refused_) return false;
  const bool has_room = light_ && light_->width_px() >= width_px && light_->height_px() >= height_px;
  if (!has_room) {
    const gl::TextureOptions options{.width_px = std::max(width_px, light_ ? light_->width_px() : 0),
                                     .height_px = std::max(height_px, light_ ? light_->height_px() : 0),
                                     .texels = gl::Texels::kHalf4};
    auto light = gl::Target::MakeWithDepth(options);
    auto between = gl::Target::Make(options);
    if (!light || !between) {
      LogWarning("light stays where it falls on skin: {}",
                 light ? between.error().message() : light.error().message());
      refused_ = true;
      return false;
    }
    light_.emplace(std::move(*light));
    between_.emplace(std::move(*between));
  }
  width_px_ = width_px;
  height_px_ = height_px;
  light_->BeginCleared(width_px, height_px);
  return true;
}

// Two Gaussians after each other are one over the plane: their sums are not, but nobody sees the difference.
void ScatterPass::Spread(const gl::Box& box) const {
  SpreadAlong(*light_, *between_, {1, 0}, box);
  SpreadAlong(*between_, *light_, {0, 1}, box);
}

// All is cleared, for what lies beside the box is looked up as well.
void ScatterPass::SpreadAlong(const gl::Target& from, const gl::Target& into, glm::vec2 axis,
                              const gl::Box& box) const {
  into.BeginCleared(width_px_, height_px_);
  gl::Apply({.depth = gl::Depth::kOff});
  from.texture().Bind(0);
  program_.Use();
  gl::Program::Set(axis_, axis);
  gl::CutTo(box);
  everywhere_.Draw();
}

}  // namespace kaori::passes
