#include "render/gl/canvas.h"

#include <GLES3/gl3.h>

#include <array>
#include <cassert>

#include <fmt/format.h>

namespace kaori::gl {
namespace {

void DeleteFramebuffer(unsigned id) {
  glDeleteFramebuffers(1, &id);
}
void DeleteRenderbuffer(unsigned id) {
  glDeleteRenderbuffers(1, &id);
}

Handle NewFramebuffer() {
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  glBindFramebuffer(GL_FRAMEBUFFER, id);
  return Handle(id, DeleteFramebuffer);
}

Handle NewRenderbuffer(const CanvasOptions& o, GLenum format) {
  GLuint id = 0;
  glGenRenderbuffers(1, &id);
  glBindRenderbuffer(GL_RENDERBUFFER, id);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, o.samples, format, o.width_px, o.height_px);
  return Handle(id, DeleteRenderbuffer);
}

void AttachTexture(const Texture& texture) {
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
}

void AttachRenderbuffer(GLenum place, const Handle& renderbuffer) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, renderbuffer.id());
}

void Aim(unsigned framebuffer, const CanvasOptions& options, const Box& box) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, options.width_px, options.height_px);
  glEnable(GL_SCISSOR_TEST);
  glScissor(box.left_px, box.bottom_px, box.width_px, box.height_px);
}

bool Sane(const CanvasOptions& o) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
  return o.width_px > 0 && o.height_px > 0 && o.width_px <= limit && o.height_px <= limit;
}

}  // namespace

Canvas::Canvas(const CanvasOptions& options) : options_(options) {
  if (options_.samples == 1) options_.samples = 0;
  const TextureOptions picture{
      .width_px = options.width_px, .height_px = options.height_px, .texels = Texels::kSrgb8};
  picture_ = Texture(picture, {});
  layer_ = Texture(picture, {});
  depth_ = NewRenderbuffer(options_, GL_DEPTH_COMPONENT16);
  layer_frame_ = NewFramebuffer();
  AttachTexture(layer_);
  picture_frame_ = NewFramebuffer();
  AttachTexture(picture_);
  sample_frame_ = NewFramebuffer();
  AttachRenderbuffer(GL_DEPTH_ATTACHMENT, depth_);
  if (options_.samples == 0) {
    AttachTexture(picture_);
    return;
  }
  samples_ = NewRenderbuffer(options_, GL_SRGB8_ALPHA8);
  AttachRenderbuffer(GL_COLOR_ATTACHMENT0, samples_);
}

Result<Canvas> Canvas::Make(const CanvasOptions& options) {
  if (!Sane(options)) {
    return FailInput(fmt::format("make a canvas of {} x {} pixels", options.width_px, options.height_px));
  }
  Canvas canvas(options);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    return Fail(std::errc::not_enough_memory,
                fmt::format("make a canvas of {} x {} pixels", options.width_px, options.height_px));
  }
  return canvas;
}

void Canvas::Begin(const Box& box) const {
  Aim(sample_frame_.id(), options_, box);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
}

void Canvas::BeginPicture(const Box& box) const {
  Aim(picture_frame_.id(), options_, box);
}

void Canvas::Resolve(unsigned from, unsigned to, const Box& box) const {
  constexpr std::array kDepth{static_cast<GLenum>(GL_DEPTH_ATTACHMENT)};
  constexpr std::array kColour{static_cast<GLenum>(GL_COLOR_ATTACHMENT0)};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  glInvalidateFramebuffer(GL_READ_FRAMEBUFFER, kDepth.size(), kDepth.data());
  if (from == to) return;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  const int right = box.left_px + box.width_px;
  const int top = box.bottom_px + box.height_px;
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(box.left_px, box.bottom_px, right, top, box.left_px, box.bottom_px, right, top,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  if (options_.samples > 0) glInvalidateFramebuffer(GL_READ_FRAMEBUFFER, kColour.size(), kColour.data());
}

void Canvas::Finish(const Box& box) const {
  Resolve(sample_frame_.id(), options_.samples == 0 ? sample_frame_.id() : picture_frame_.id(), box);
}

void Canvas::FinishLayer(const Box& box) const {
  Resolve(sample_frame_.id(), layer_frame_.id(), box);
  BeginPicture(box);
}

void Canvas::ReadPixels(std::span<std::uint8_t> bytes) const {
  assert(bytes.size() >=
         static_cast<std::size_t>(options_.width_px) * static_cast<std::size_t>(options_.height_px) * 4);
  glBindFramebuffer(GL_FRAMEBUFFER, picture_frame_.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, options_.width_px, options_.height_px, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
}

}  // namespace kaori::gl
