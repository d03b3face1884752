// What a frame is drawn on: a layer with samples and depth, and the picture that layers are laid on.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/result.h"
#include "render/gl/box.h"
#include "render/gl/damage.h"
#include "render/gl/handle.h"
#include "render/gl/target.h"

namespace kaori::gl {

// Each 1 up to the driver's limit (GL_MAX_RENDERBUFFER_SIZE).
struct CanvasOptions {
  int width_px = 0;
  int height_px = 0;
};

// The picture is sRGB-coded and is written with linear light: blending on it is right. A layer has four
// samples a pixel and depth; it holds square roots of linear light, 8 bit, and coverage in alpha. Coding each
// sample as sRGB costs a software renderer half its time, a square root next to nothing; whoever lays the
// layer on the picture squares it, sample by sample.
class Canvas {
 public:
  Canvas() = default;
  // On the current context. Errors: not_enough_memory; invalid_argument (a size below 1 or beyond the
  // driver's limit).
  static Result<Canvas> Make(const CanvasOptions& options);

  // Drawing goes to the layer within `whole` from here on; `parts` are cleared to nothing, and their depth to
  // far.
  void BeginLayer(std::span<const Box> parts, const Box& whole) const;
  // Drawing goes to the picture from here on, without depth: nowhere, until Within says where. What is
  // written is linear light, which the framebuffer codes (GL_FRAMEBUFFER_SRGB is always on in GLES).
  void BeginPicture() const;
  // Limits drawing to `box` by the scissor test. Of the picture, all of `box` counts as drawn on.
  void Within(const Box& box) const;
  // What of the picture was drawn on since this was asked last, or since the canvas was made: then all of it.
  Damage AcquireDamage() const;
  // The layer as a texture: one with samples where the context reads samples, else resolved within `box` now.
  // Its depth is given up, so nothing more can be drawn on this layer. Leaves the layer's or the resolved
  // framebuffer bound, and without samples the scissor test off: BeginPicture comes next.
  void BindLayer(unsigned unit, const Box& box) const;

  // Waits until the picture is finished and copies it out: R, G, B, X; the bottom row first. `bytes` holds
  // width * height * 4. Codes are copied, not light.
  void ReadPixels(std::span<std::uint8_t> bytes) const { picture_.ReadPixels(bytes); }

  // The picture as a texture whose codes are read as they are, without smoothing, but by texelFetch. Needs
  // EXT_texture_sRGB_decode. The picture must not be drawn on meanwhile.
  void BindPictureCodes(unsigned unit) const;

  // Copies the picture onto a target of another size, upside down: its top row becomes the first. Smoothed
  // between the four nearest pixels: shrunk to less than half, it skips some. Leaves the scissor test off.
  void ShrinkTo(const Target& target) const;

  // Who drew the picture last, and as which frame. A pass that finds the stamp that it set last may count on
  // the picture as it left it; whoever else draws on the picture sets another, or none.
  struct Stamp {
    const void* painter = nullptr;
    std::uint64_t frame = 0;
    bool operator==(const Stamp&) const = default;
  };
  void SetStamp(const Stamp& stamp) const { stamp_ = stamp; }
  const Stamp& stamp() const { return stamp_; }

  int width_px() const { return options_.width_px; }
  int height_px() const { return options_.height_px; }
  // All of the canvas.
  Box whole() const { return {0, 0, options_.width_px, options_.height_px}; }

 private:
  explicit Canvas(const CanvasOptions& options)
      : options_(options), damage_(options.width_px, options.height_px) {
    damage_.AddAll();
  }
  // Each makes one of the framebuffers; false where the driver cannot draw on it.
  bool MakePicture();
  bool MakeLayer(bool reads_samples);

  CanvasOptions options_;
  Target picture_;
  Handle samples_texture_;  // The layer's samples: a texture where shaders read single samples,
  Handle samples_;          // else a renderbuffer,
  Target layer_;            // which is resolved into this.
  // Sixteen bits, with the layer's samples; never read by shaders.
  Handle depth_;
  // With the samples and the depth.
  Handle layer_frame_;
  // These belong to the picture, which drawing changes as well; the last says whether it is drawn on now.
  mutable Stamp stamp_;
  mutable Damage damage_;
  mutable bool on_picture_ = false;
};

}  // namespace kaori::gl
