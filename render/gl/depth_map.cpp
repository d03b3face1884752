#include "render/gl/depth_map.h"

#include <GLES3/gl3.h>
#include <fmt/format.h>

#include "render/gl/target.h"

namespace kaori::gl {
namespace {

void DeleteDepths(unsigned id) {
  glDeleteTextures(1, &id);
}

Handle NewDepths(int side_px) {
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(GL_TEXTURE_2D, id);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, side_px, side_px);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  return Handle(id, DeleteDepths);
}

}  // namespace

Result<DepthMap> DepthMap::Make(int side_px) {
  DepthMap map;
  map.side_px_ = side_px;
  map.texture_ = NewDepths(side_px);
  map.frame_ = NewFramebuffer();
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map.texture_.id(), 0);
  const GLenum nothing = GL_NONE;
  glDrawBuffers(1, &nothing);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return map;
  return Fail(std::errc::not_enough_memory, fmt::format("make a depth map of {0} x {0} texels", side_px));
}

// glClear obeys the depth mask, which the last pass may have left off.
void DepthMap::Begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.id());
  glViewport(0, 0, side_px_, side_px_);
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
}

void DepthMap::Bind(unsigned unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture_.id());
}

}  // namespace kaori::gl
