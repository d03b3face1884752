// A canvas's picture, made small and copied out.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/result.h"
#include "render/gl/canvas.h"
#include "render/gl/handle.h"
#include "render/gl/texture.h"

namespace kaori::gl {

// For people who look at the box from afar: a few hundred pixels wide. On the thread of its context. Reading
// waits for the GPU, so it is done seldom.
class SmallPicture {
 public:
  // On the current context. Errors: not_enough_memory.
  static Result<SmallPicture> Make(int width_px, int height_px);

  // Waits until the canvas's picture is finished and copies it out: R, G, B, X; the top row first. `bytes`
  // holds width * height * 4: asserted. Leaves its own framebuffer bound.
  void Read(const Canvas& canvas, std::span<std::uint8_t> bytes) const;

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

 private:
  // Without objects of GL; Make adds them.
  SmallPicture(int width_px, int height_px) : width_px_(width_px), height_px_(height_px) {}

  int width_px_;
  int height_px_;
  Texture picture_;
  Handle frame_;
};

}  // namespace kaori::gl
