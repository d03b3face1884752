#include "render/gl/canvas.h"

#include <GLES3/gl31.h>
// After it.
#include <GLES2/gl2ext.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "render/gl/context.h"
#include "render/gl/draw_state.h"

namespace kaori::gl {
namespace {

// As many as layer.frag reads.
constexpr int kSamples = 4;

void DeleteRenderbuffer(unsigned id) {
  glDeleteRenderbuffers(1, &id);
}
void DeleteCanvasTexture(unsigned id) {
  glDeleteTextures(1, &id);
}

// With so many samples, 0 for none; it stays bound.
Handle NewRenderbuffer(int samples, int width_px, int height_px, GLenum format) {
  GLuint id = 0;
  glGenRenderbuffers(1, &id);
  glBindRenderbuffer(GL_RENDERBUFFER, id);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width_px, height_px);
  return Handle(id, DeleteRenderbuffer);
}

// GLES 3.1. Fixed sample locations, so that every driver smooths edges alike.
Handle NewSamplesTexture(const CanvasOptions& o) {
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, id);
  glTexStorage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, kSamples, GL_RGBA8, o.width_px, o.height_px, GL_TRUE);
  return Handle(id, DeleteCanvasTexture);
}

void AttachRenderbuffer(GLenum attachment, const Handle& renderbuffer) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer.id());
}

// Drawing goes to this framebuffer, seen as a picture of this size, and within `box`.
void Aim(unsigned framebuffer, int width_px, int height_px, const Box& box) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width_px, height_px);
  CutTo(box);
}

int Supersampled(int size_px) {
  return static_cast<int>(std::ceil(static_cast<float>(size_px) * kSupersampling - 0.01F));
}

// The layer is as large as the picture, or larger.
bool IsValid(const CanvasOptions& o) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
  if (o.antialiasing == Antialiasing::kSupersample)
    limit = static_cast<int>(static_cast<float>(limit) / kSupersampling);
  return o.width_px > 0 && o.height_px > 0 && o.width_px <= limit && o.height_px <= limit;
}

// The depth is not looked at again: a tiled GPU need not write it back.
void ForgetDepth() {
  constexpr std::array kDepth{static_cast<GLenum>(GL_DEPTH_ATTACHMENT)};
  glInvalidateFramebuffer(GL_FRAMEBUFFER, kDepth.size(), kDepth.data());
}

}  // namespace

// Framebuffers stay bound: whoever draws next binds its own.
Result<Canvas> Canvas::Make(const CanvasOptions& options) {
  const auto attempt = fmt::format("make a canvas of {} x {} pixels", options.width_px, options.height_px);
  if (!IsValid(options)) return FailInput(attempt);
  Canvas canvas(options);
  const bool made = canvas.MakePicture() && canvas.MakeLayer(Context::ReadsSamples());
  if (!made) return Fail(std::errc::not_enough_memory, attempt);
  return canvas;
}

// The picture has no depth: layers are laid on it in order.
bool Canvas::MakePicture() {
  auto picture = Target::Make(
      {.width_px = options_.width_px, .height_px = options_.height_px, .texels = Texels::kSrgb8});
  if (picture) picture_ = std::move(*picture);
  return picture.has_value();
}

// Sixteen bits of depth are enough: all that is drawn lies within 0.9 m (scene::ProjectionOf).
bool Canvas::MakeLayer(bool reads_samples) {
  // Where shaders cannot read samples, a renderbuffer is resolved into a texture by a blit, which averages
  // square roots instead of light: edges are a little darker then.
  if (!has_samples() || !reads_samples) {
    auto layer = Target::Make({.width_px = layer_width_px(), .height_px = layer_height_px()});
    if (!layer) return false;
    layer_ = std::move(*layer);
  }
  const int samples = has_samples() ? kSamples : 0;
  depth_ = NewRenderbuffer(samples, layer_width_px(), layer_height_px(), GL_DEPTH_COMPONENT16);
  layer_frame_ = NewFramebuffer();
  AttachRenderbuffer(GL_DEPTH_ATTACHMENT, depth_);
  if (!has_samples()) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, layer_.texture().id(), 0);
  } else if (reads_samples) {
    samples_texture_ = NewSamplesTexture(options_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE,
                           samples_texture_.id(), 0);
  } else {
    samples_ = NewRenderbuffer(samples, layer_width_px(), layer_height_px(), GL_RGBA8);
    AttachRenderbuffer(GL_COLOR_ATTACHMENT0, samples_);
  }
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

int Canvas::layer_width_px() const {
  return has_samples() ? options_.width_px : Supersampled(options_.width_px);
}
int Canvas::layer_height_px() const {
  return has_samples() ? options_.height_px : Supersampled(options_.height_px);
}

glm::dvec2 Canvas::texels_per_pixel() const {
  return glm::dvec2(layer_width_px(), layer_height_px()) / glm::dvec2(options_.width_px, options_.height_px);
}

// Rounded outwards: whoever makes the layer smaller reads what lies partly within the box.
Box Canvas::OnLayer(const Box& box) const {
  if (has_samples() || box.empty()) return box;
  const glm::dvec2 per_pixel = texels_per_pixel();
  const int left_px = static_cast<int>(std::floor(box.left_px * per_pixel.x));
  const int bottom_px = static_cast<int>(std::floor(box.bottom_px * per_pixel.y));
  const int right_px = static_cast<int>(std::ceil((box.left_px + box.width_px) * per_pixel.x));
  const int top_px = static_cast<int>(std::ceil((box.bottom_px + box.height_px) * per_pixel.y));
  return {left_px, bottom_px, std::min(right_px, layer_width_px()) - left_px,
          std::min(top_px, layer_height_px()) - bottom_px};
}

// Only the parts are cleared: what lies outside of them is never read.
void Canvas::BeginLayer(std::span<const Box> parts, const Box& whole) const {
  Aim(layer_frame_.id(), layer_width_px(), layer_height_px(), OnLayer(whole));
  // glClear obeys the mask, which the last pass may have left off.
  glDepthMask(GL_TRUE);
  glClearColor(0, 0, 0, 0);
  for (const Box& part : parts) {
    if (part.empty()) continue;
    CutTo(OnLayer(part));
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  CutTo(OnLayer(whole));
}

void Canvas::BeginPicture() const {
  Aim(picture_.id(), options_.width_px, options_.height_px, {});
}

void Canvas::Within(const Box& box) const {
  CutTo(box);
  damage_.Add(box);
}

// Within counts boxes, not pixels: what is drawn is all of a box, or near it.
Damage Canvas::AcquireDamage() const {
  return std::exchange(damage_, Damage(options_.width_px, options_.height_px));
}

// Where shaders read samples, and where there are none, the layer is bound as it is, and nothing is copied.
void Canvas::BindLayer(unsigned unit, const Box& box) const {
  glBindFramebuffer(GL_FRAMEBUFFER, layer_frame_.id());
  ForgetDepth();
  glActiveTexture(GL_TEXTURE0 + unit);
  if (samples_texture_.id() != 0) {
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, samples_texture_.id());
    return;
  }
  glBindTexture(GL_TEXTURE_2D, layer_.texture().id());
  if (!has_samples()) return;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, layer_.id());
  glDisable(GL_SCISSOR_TEST);
  // A resolve copies samples to the same place: GLES 3.0 allows no other box, and demands NEAREST.
  const int right = box.left_px + box.width_px;
  const int top = box.bottom_px + box.height_px;
  glBlitFramebuffer(box.left_px, box.bottom_px, right, top, box.left_px, box.bottom_px, right, top,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

// The texture decodes sRGB where it is looked up, unless it is told not to. It is looked up nowhere else.
void Canvas::BindPictureCodes(unsigned unit) const {
  picture_.texture().Bind(unit);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, GL_SKIP_DECODE_EXT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

// The two y of the target change places, which turns the picture over on its way.
void Canvas::ShrinkTo(const Target& target) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.id());
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(0, 0, options_.width_px, options_.height_px, 0, target.height_px(), target.width_px(), 0,
                    GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

}  // namespace kaori::gl
