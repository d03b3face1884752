// A texture that is drawn on, without samples; with depth where that is asked for.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/result.h"
#include "render/gl/box.h"
#include "render/gl/handle.h"
#include "render/gl/texture.h"

namespace kaori::gl {

// A framebuffer without anything attached, which stays bound.
Handle NewFramebuffer();

// Pixels are written as the texture's kind has them; what was there is kept. On the thread of its context.
// Its texture must not be looked up while it is drawn on.
class Target {
 public:
  Target() = default;
  // On the current context. Errors: not_enough_memory (or a format that the driver does not draw on).
  static Result<Target> Make(const TextureOptions& options);

  // The same with 24 bits of depth.
  static Result<Target> MakeWithDepth(const TextureOptions& options);

  // Drawing goes to `box` from here on, seen as a part of a picture of this size, which is no larger than the target.
  // Sets framebuffer, viewport and scissor test.
  void BeginWithin(int width_px, int height_px, const Box& box) const;
  // Makes what drawing goes to black, without coverage, and its depth far.
  void Clear() const;

  // Drawing goes to all of it from here on: sets framebuffer and viewport, and turns the scissor test off.
  void Begin() const;

  // Waits until the picture is finished and copies it out: R, G, B, X; the row at v = 0 first. `bytes` holds
  // width * height * 4.
  void ReadPixels(std::span<std::uint8_t> bytes) const;

  // Of its framebuffer.
  unsigned id() const { return frame_.id(); }
  // What was drawn; bind it when drawing goes elsewhere.
  const Texture& texture() const { return texture_; }
  int width_px() const { return options_.width_px; }
  int height_px() const { return options_.height_px; }

 private:
  TextureOptions options_;
  Texture texture_;
  // None where no depth was asked for.
  Handle depth_;
  Handle frame_;
};

}  // namespace kaori::gl
