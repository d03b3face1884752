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
  pass.within_ = pass.program_.Find("within");
  pass.everywhere_ = gl::Mesh({}, 3);
  return pass;
}

// A refusal of the driver is logged once and remembered: the show goes on with light that stays where it falls. Targets
// only ever grow, so that screens of several sizes, drawn in turns, make nothing anew.
bool ScatterPass::Begin(int width_px, int height_px, const gl::Box& figure) {
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
  figure_ = figure;
  light_->BeginWithin(width_px, height_px, figure);
  light_->Clear();
  return true;
}

// Two Gaussians after each other are one over the plane: their sums are not, but nobody sees the difference.
void ScatterPass::Spread() const {
  SpreadAlong(*light_, *between_, {1, 0});
  SpreadAlong(*between_, *light_, {0, 1});
}

// Every pixel of the figure is written, so nothing is cleared: on small graphics that costs as much as all else.
void ScatterPass::SpreadAlong(const gl::Target& from, const gl::Target& into, const glm::ivec2& axis) const {
  into.BeginWithin(width_px_, height_px_, figure_);
  gl::Apply({.depth = gl::Depth::kOff});
  from.texture().Bind(0);
  program_.Use();
  gl::Program::Set(axis_, axis);
  gl::Program::Set(within_,
                   glm::ivec4(figure_.left_px, figure_.bottom_px, figure_.left_px + figure_.width_px - 1,
                              figure_.bottom_px + figure_.height_px - 1));
  everywhere_.Draw();
}

}  // namespace kaori::passes
