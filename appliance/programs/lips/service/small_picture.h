// What the camera sees, made small for a person's eyes, with how much each pixel is paint beside its colour.
#pragma once

#include <cstdint>
#include <span>

#include "appliance/programs/lips/paint_key.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

struct SmallSize {
  int width_px = 0;
  int height_px = 0;
};

// The largest whole fraction of the picture that fits into `most_px` each way.
SmallSize SmallSizeOf(const decode::Planes& planes, int most_px);

// R, G, B and the soft key (0 .. 255) of each pixel, top row first; `into` has room for size * 4 bytes.
void DrawSmall(const decode::Planes& planes, const PaintKey& key, SmallSize size,
               std::span<std::uint8_t> into);

}  // namespace kaori::lips
