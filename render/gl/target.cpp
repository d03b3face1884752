#include "render/gl/target.h"

#include <GLES3/gl3.h>
#include <fmt/format.h>

#include <cassert>

#include "render/gl/draw_state.h"

namespace kaori::gl {
namespace {

void DeleteFramebuffer(unsigned id) {
  glDeleteFramebuffers(1, &id);
}
void DeleteTargetDepth(unsigned id) {
  glDeleteRenderbuffers(1, &id);
}

// Attached to the framebuffer that is bound.
Handle AttachDepth(const TextureOptions& o) {
  GLuint id = 0;
  glGenRenderbuffers(1, &id);
  glBindRenderbuffer(GL_RENDERBUFFER, id);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, o.width_px, o.height_px);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, id);
  return Handle(id, DeleteTargetDepth);
}

}  // namespace

Handle NewFramebuffer() {
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  glBindFramebuffer(GL_FRAMEBUFFER, id);
  return Handle(id, DeleteFramebuffer);
}

// Formats that a driver may refuse to draw on (floats) show only here.
Result<Target> Target::Make(const TextureOptions& options) {
  Target target;
  target.options_ = options;
  target.texture_ = Texture(options);
  target.frame_ = NewFramebuffer();
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture_.id(), 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return target;
  return Fail(std::errc::not_enough_memory,
              fmt::format("make a target of {} x {} pixels", options.width_px, options.height_px));
}

Result<Target> Target::MakeWithDepth(const TextureOptions& options) {
  auto target = Make(options);
  if (!target) return target;
  target->depth_ = AttachDepth(options);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return target;
  return Fail(std::errc::not_enough_memory,
              fmt::format("make a depth of {} x {} pixels", options.width_px, options.height_px));
}

void Target::BeginWithin(int width_px, int height_px, const Box& box) const {
  assert(width_px <= options_.width_px && height_px <= options_.height_px);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.id());
  glViewport(0, 0, width_px, height_px);
  CutTo(box);
}

// glClear obeys the depth mask, which the last pass may have left off; of a target without depth it clears none.
void Target::Clear() const {
  glDepthMask(GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

// What is drawn covers it, or adds to it: nothing is cleared.
void Target::Begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.id());
  glViewport(0, 0, options_.width_px, options_.height_px);
  glDisable(GL_SCISSOR_TEST);
}

void Target::ReadPixels(std::span<std::uint8_t> bytes) const {
  assert(bytes.size() >= std::size_t(options_.width_px) * std::size_t(options_.height_px) * 4);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);  // Rows of four-byte pixels are always aligned.
  glReadPixels(0, 0, options_.width_px, options_.height_px, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
}

}  // namespace kaori::gl
