// What a frame is drawn on: samples and depth, and the picture that they are resolved into.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/result.h"
#include "render/gl/handle.h"
#include "render/gl/texture.h"

namespace kaori::gl {

struct CanvasOptions {
  int width_px = 0;
  int height_px = 0;
  int samples = 4;  // For each pixel; 0 or 1 draws straight into the picture.
};

// Pixels from the left bottom corner.
struct Box {
  int left_px = 0;
  int bottom_px = 0;
  int width_px = 0;
  int height_px = 0;
};

// The picture is sRGB-coded, 8 bit; shaders write linear light and blending happens in linear light.
class Canvas {
 public:
  Canvas() = default;
  // Errors: not_enough_memory, invalid_argument (a size below 1 or beyond the driver's limit).
  static Result<Canvas> Make(const CanvasOptions& options);

  // Drawing goes to the samples within `box` from here on; their depth is cleared, their colour is not.
  void Begin(const Box& box) const;
  // The samples in `box` become the picture.
  void Finish(const Box& box) const;
  // The samples in `box` become layer(); drawing goes to the picture from here on.
  void FinishLayer(const Box& box) const;
  // Drawing goes to the picture itself, where there are no samples and no depth.
  void BeginPicture(const Box& box) const;

  // Waits until the picture is finished and copies it out: R, G, B, X; the bottom row first.
  // `bytes` holds width * height * 4.
  void ReadPixels(std::span<std::uint8_t> bytes) const;

  const Texture& layer() const { return layer_; }
  int width_px() const { return options_.width_px; }
  int height_px() const { return options_.height_px; }
  int samples() const { return options_.samples; }
  Box whole() const { return {0, 0, options_.width_px, options_.height_px}; }

 private:
  explicit Canvas(const CanvasOptions& options);
  void Resolve(unsigned from, unsigned to, const Box& box) const;

  CanvasOptions options_;
  Texture picture_;
  Texture layer_;
  Handle samples_;  // Renderbuffers.
  Handle depth_;
  Handle picture_frame_;  // Framebuffers.
  Handle layer_frame_;
  Handle sample_frame_;
};

}  // namespace kaori::gl
