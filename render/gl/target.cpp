#include "render/gl/target.h"

#include <GLES3/gl3.h>
#include <fmt/format.h>

namespace kaori::gl {
namespace {

void TargetFramebufferDelete(unsigned id) {
  glDeleteFramebuffers(1, &id);
}

}  // namespace

// Formats that a driver may refuse to draw on (floats) show only here.
Result<Target> Target::Make(const TextureOptions& options) {
  Target target;
  target.options_ = options;
  target.texture_ = Texture(options, {});
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  target.frame_ = Handle(id, TargetFramebufferDelete);
  glBindFramebuffer(GL_FRAMEBUFFER, id);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture_.id(), 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return target;
  return Fail(std::errc::not_enough_memory,
              fmt::format("make a target of {} x {} pixels", options.width_px, options.height_px));
}

// What is drawn covers it, or adds to it: nothing is cleared.
void Target::Begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.id());
  glViewport(0, 0, options_.width_px, options_.height_px);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace kaori::gl
