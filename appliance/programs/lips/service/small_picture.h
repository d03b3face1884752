// The camera's picture, made small for the desk's page; each pixel has its colour and how much it is paint.
#pragma once

#include <cstdint>
#include <span>

#include "appliance/programs/lips/paint_key.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// Both sides at least 1.
struct SmallSize {
  int width_px = 0;
  int height_px = 0;
};

// The size of the largest whole fraction of the picture that fits into `max_px` in each direction.
SmallSize SmallSizeOf(const decode::Planes& planes, int max_px);

// Writes R, G, B and the soft key (0 .. 255) of each pixel, top row first. `into` must have room for width x
// height x 4 bytes. Nearest pixel, no filter: it is to show what the key sees. Pure.
void DrawSmall(const decode::Planes& planes, const PaintKey& key, SmallSize size,
               std::span<std::uint8_t> into);

}  // namespace kaori::lips
