#include "render/gl/small_picture.h"

#include <GLES3/gl31.h>

#include <cassert>

namespace kaori::gl {
namespace {

void SmallPictureFramebufferDelete(unsigned id) {
  glDeleteFramebuffers(1, &id);
}

}  // namespace

// sRGB like the canvas's picture, so that the blit filters light and keeps the coding.
Result<SmallPicture> SmallPicture::Make(int width_px, int height_px) {
  SmallPicture small(width_px, height_px);
  small.picture_ = Texture({.width_px = width_px, .height_px = height_px, .texels = Texels::kSrgb8}, {});
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  small.frame_ = Handle(id, SmallPictureFramebufferDelete);
  glBindFramebuffer(GL_FRAMEBUFFER, id);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, small.picture_.id(), 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return Fail(std::errc::not_enough_memory, "make a small picture");
  return small;
}

void SmallPicture::Read(const Canvas& canvas, std::span<std::uint8_t> bytes) const {
  assert(bytes.size() >= std::size_t(width_px_) * std::size_t(height_px_) * 4);
  canvas.ShrinkTo(frame_.id(), width_px_, height_px_);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width_px_, height_px_, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
}

}  // namespace kaori::gl
