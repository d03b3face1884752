// What a frame is drawn on: a layer with depth, and the picture that layers are laid on.
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

#include "drivers/base/result.h"
#include "render/gl/box.h"
#include "render/gl/damage.h"
#include "render/gl/handle.h"
#include "render/gl/target.h"

namespace kaori::gl {

// How edges of what is drawn on a layer become smooth.
enum class Antialiasing : std::uint8_t {
  // Four samples a pixel, which share their colour within a triangle: next to nothing on a graphics card. A software
  // renderer takes more than twice as long for a figure of many small triangles.
  kMultisample,
  // One sample a pixel of a layer that is larger than the picture (kSupersampling), and is made smaller as it is laid.
  kSupersample,
};

// So many times as wide and as high as the picture is a layer that is made smaller.
constexpr float kSupersampling = 4.0F / 3;

// Each size 1 up to the driver's limit (GL_MAX_RENDERBUFFER_SIZE), as the layer has it.
struct CanvasOptions {
  int width_px = 0;
  int height_px = 0;
  Antialiasing antialiasing = Antialiasing::kSupersample;
};

// The picture is sRGB-coded and is written with linear light: blending on it is right. A layer has depth, and the samples
// of its antialiasing; it holds square roots of linear light, 8 bit, and coverage in alpha. Coding each
// sample as sRGB costs a software renderer half its time, a square root next to nothing; whoever lays the
// layer on the picture squares it, sample by sample.
class Canvas {
 public:
  Canvas() = default;
  // On the current context. Errors: not_enough_memory; invalid_argument (a size below 1 or beyond the
  // driver's limit).
  static Result<Canvas> Make(const CanvasOptions& options);

  // Drawing goes to the layer within `whole` from here on; `parts` are cleared to nothing, and their depth to
  // far. Both are pixels of the picture.
  void BeginLayer(std::span<const Box> parts, const Box& whole) const;
  // Drawing goes to the picture from here on, without depth: nowhere, until Within says where. What is
  // written is linear light, which the framebuffer codes (GL_FRAMEBUFFER_SRGB is always on in GLES).
  void BeginPicture() const;
  // Limits drawing to `box` of the picture by the scissor test. All of `box` counts as drawn on.
  void Within(const Box& box) const;
  // What of the picture was drawn on since this was asked last, or since the canvas was made: then all of it.
  Damage AcquireDamage() const;
  // The layer as a texture: one with samples if reads_samples(), else of single texels, resolved within `box` of the
  // picture now where it has samples. Its depth is given up, so nothing more can be drawn on this layer. Leaves the layer's
  // or the resolved framebuffer bound, and the scissor test perhaps off: BeginPicture comes next.
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
  // Of the layer, whose viewport shows what the picture's does: the picture's size, or larger (kSupersampling, rounded up).
  int layer_width_px() const;
  int layer_height_px() const;
  // How many texels of the layer a pixel of the picture has, across and up: 1 or more.
  glm::dvec2 texels_per_pixel() const;
  // What of the layer holds a box of the picture.
  Box OnLayer(const Box& box) const;
  Antialiasing antialiasing() const { return options_.antialiasing; }
  // Whether a pixel of the layer has several samples.
  bool has_samples() const { return options_.antialiasing == Antialiasing::kMultisample; }
  // Whether it is bound as a texture with them.
  bool reads_samples() const { return samples_texture_.id() != 0; }

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
  Target layer_;            // which is resolved into this; without samples this is the layer.
  // Sixteen bits, with the layer's samples; never read by shaders.
  Handle depth_;
  // With the samples and the depth.
  Handle layer_frame_;
  // These belong to the picture, which drawing changes as well.
  mutable Stamp stamp_;
  mutable Damage damage_;
};

}  // namespace kaori::gl
