// What the simulated camera makes of its picture, so that every format that lips read is tested.
// YUYV pictures as other cameras send them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kaori::sim {

// `width` and `height` are even. `into` holds width * height * 3 / 2 bytes; 0 is returned where it is
// shorter. Colours of two rows are averaged. Returns the bytes used.
std::size_t YuyvToNv12(std::span<const std::uint8_t> yuyv, int width_px, int height_px,
                       std::span<std::uint8_t> into);

// `quality` is libjpeg's, 1 .. 100. Subsampled 4:2:2, as YUYV is. Returns the bytes used, 0
// where `into` is too small for the picture.
std::size_t YuyvToJpeg(std::span<const std::uint8_t> yuyv, int width_px, int height_px,
                       std::span<std::uint8_t> into, int quality = 85);

}  // namespace kaori::sim
