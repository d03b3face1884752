// A rectangle of pixels.
#pragma once

namespace kaori::gl {

// Pixels from the left bottom corner.
struct Box {
  int left_px = 0;
  int bottom_px = 0;
  int width_px = 0;
  int height_px = 0;
  // Whether it holds no pixel.
  bool empty() const { return width_px <= 0 || height_px <= 0; }
};

}  // namespace kaori::gl
