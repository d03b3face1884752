// How far away the nearest surface is, for each direction of a lamp: a picture of depths alone.
#pragma once

#include "drivers/base/result.h"
#include "render/gl/handle.h"

namespace kaori::gl {

// Square. Shaders read it as a sampler2DShadow, which compares and smooths between the four nearest texels;
// beyond its edges a depth goes on as the edge is. It must not be looked up while it is drawn on. On the
// thread of its context.
class DepthMap {
 public:
  DepthMap() = default;
  // On the current context; `side_px` is 1 up to the driver's limit (GL_MAX_TEXTURE_SIZE). Errors:
  // not_enough_memory (or depths that the driver does not draw on).
  static Result<DepthMap> Make(int side_px);

  // Drawing goes to all of it from here on, and every depth is the farthest: sets framebuffer and viewport,
  // and turns the scissor test off. Colours that are drawn are lost.
  void Begin() const;
  // Makes samplers that read texture unit `unit` look this up. Leaves that unit active.
  void Bind(unsigned unit) const;

 private:
  int side_px_ = 0;
  Handle texture_;
  Handle frame_;
};

}  // namespace kaori::gl
