// What a frame is drawn on: a layer with samples and depth, and the picture that layers are laid on.
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "drivers/base/result.h"
#include "render/gl/handle.h"
#include "render/gl/texture.h"

namespace kaori::gl {

struct CanvasOptions {
  int width_px = 0;
  int height_px = 0;
  // For each pixel of the layer: 4, or 0 for no smooth edges. Other numbers count as the nearer.
  int samples = 4;
  // The picture takes sRGB's codes as they are, as in 1993, and not light: less work, and no right blending.
  bool stores_codes = false;
};

// Pixels from the left bottom corner.
struct Box {
  int left_px = 0;
  int bottom_px = 0;
  int width_px = 0;
  int height_px = 0;
  bool empty() const { return width_px <= 0 || height_px <= 0; }
};

// The picture is sRGB-coded and takes linear light: blending on it is right. A layer holds square roots of
// linear light, 8 bit, and coverage in alpha. Coding each sample as sRGB costs a software renderer half its
// time, a square root next to nothing; whoever lays the layer on the picture squares it, sample by sample.
class Canvas {
 public:
  Canvas() = default;
  // On the current context. Errors: not_enough_memory; invalid_argument (a size below 1 or beyond the
  // driver's limit).
  static Result<Canvas> Make(const CanvasOptions& options);

  // Drawing goes to the layer within `whole` from here on; `parts` are cleared to nothing, and their depth to
  // far.
  void BeginLayer(std::span<const Box> parts, const Box& whole) const;
  // Drawing goes to the picture from here on, without depth: nowhere, until Within says where.
  void BeginPicture() const;
  void Within(const Box& box) const;
  // Drawing goes straight to the picture, which becomes `background` (linear light, or a code), with depth:
  // for canvases without samples.
  void BeginPlain(const glm::vec3& background) const;
  // The layer as a texture: one with samples where the context reads samples, else resolved within `box` now.
  void BindLayer(unsigned unit, const Box& box) const;

  // Waits until the picture is finished and copies it out: R, G, B, X; the bottom row first.
  // `bytes` holds width * height * 4.
  void ReadPixels(std::span<std::uint8_t> bytes) const;

  // The picture as a texture whose codes are read as they are, without smoothing, but by texelFetch.
  void BindPictureCodes(unsigned unit) const;

  // Copies the picture onto a framebuffer of another size, upside down: its top row becomes the first.
  void ShrinkTo(unsigned framebuffer, int width_px, int height_px) const;

  // Whoever finds here what they signed with last may count on the picture as they left it.
  struct Stamp {
    const void* painter = nullptr;
    std::uint64_t frame = 0;
    bool operator==(const Stamp&) const = default;
  };
  void SetStamp(const Stamp& stamp) const { stamp_ = stamp; }
  const Stamp& stamp() const { return stamp_; }

  int width_px() const { return options_.width_px; }
  int height_px() const { return options_.height_px; }
  int samples() const { return options_.samples; }
  bool layer_has_samples() const { return samples_texture_.id() != 0; }
  Box whole() const { return {0, 0, options_.width_px, options_.height_px}; }

 private:
  explicit Canvas(const CanvasOptions& options) : options_(options) {}
  bool MakePicture();
  bool MakeLayer(bool reads_samples);
  void AttachLayerColour(bool reads_samples);

  CanvasOptions options_;
  Texture picture_;
  Texture layer_;           // Without samples: drawn to, or resolved into.
  Handle samples_texture_;  // The samples of the layer, one of the two where it has any.
  Handle samples_;
  Handle depth_;
  Handle picture_frame_;
  Handle layer_frame_;  // With the samples and the depth.
  Handle resolved_frame_;
  mutable Stamp stamp_;  // Belongs to the picture, which drawing changes as well.
};

}  // namespace kaori::gl
