// Rectangles of one colour in pictures.
#pragma once

#include <array>
#include <cstdint>

#include "render/image/png.h"

namespace kaori::image {

using Colour = std::array<std::uint8_t, 3>;  // R, G, B, as stored in the picture.

// A rectangle from left, bottom up to right, top, both exclusive, cut at the picture's edges; X stays.
void Fill(Picture& picture, int left, int bottom, int right, int top, const Colour& colour);

}  // namespace kaori::image
