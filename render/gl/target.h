// A texture that is drawn on, without samples or depth.
#pragma once

#include "drivers/base/result.h"
#include "render/gl/handle.h"
#include "render/gl/texture.h"

namespace kaori::gl {

// Pixels are written as the texture's kind has them; what was there is kept. On the thread of its context.
// Its texture must not be looked up while it is drawn on.
class Target {
 public:
  Target() = default;
  // On the current context. Errors: not_enough_memory (or a format that the driver does not draw on).
  static Result<Target> Make(const TextureOptions& options);

  // Drawing goes to all of it from here on: sets framebuffer and viewport, and turns the scissor test off.
  void Begin() const;

  // What was drawn; bind it when drawing goes elsewhere.
  const Texture& texture() const { return texture_; }
  int width_px() const { return options_.width_px; }
  int height_px() const { return options_.height_px; }

 private:
  TextureOptions options_;
  Texture texture_;
  Handle frame_;
};

}  // namespace kaori::gl
