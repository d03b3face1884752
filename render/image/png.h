// Pictures as PNG files: what people look at, and what tests compare.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::image {

// 8-bit R, G, B, X in memory order; row 0 is the bottom row, as GLES reads pixels.
struct Picture {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgbx;

  static Picture Blank(int width_px, int height_px) {
    return {width_px, height_px,
            std::vector<std::uint8_t>(static_cast<std::size_t>(width_px * height_px) * 4)};
  }
};

// Writes R, G, B; X is dropped. Errors: as open(2); io_error.
Result<void> WritePng(const std::filesystem::path& file, const Picture& picture);

// The same as bytes of a file. Errors: io_error.
Result<std::vector<std::uint8_t>> EncodePng(const Picture& picture);

// Any PNG, as 8-bit RGB. Errors: as open(2); invalid_argument (not a valid PNG).
Result<Picture> ReadPng(const std::filesystem::path& file);

// Copies `from` into `into` with its lower left corner at (x_px, y_px); it must fit.
void Paste(const Picture& from, Picture& into, int x_px, int y_px);

}  // namespace kaori::image
