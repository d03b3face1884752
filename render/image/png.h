// Pictures as PNG files: what people look at, and what tests compare.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::image {

// 8-bit R, G, B, X in memory order; row 0 is the bottom row, as GLES reads pixels. Codes are sRGB as a screen
// shows them. X means nothing but where a function says so.
struct Picture {
  int width_px = 0;
  int height_px = 0;
  // width * height * 4 bytes, without padding between rows.
  std::vector<std::uint8_t> rgbx;

  // All zero: black.
  static Picture Blank(int width_px, int height_px) {
    return {width_px, height_px,
            std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width_px) *
                                      static_cast<std::size_t>(height_px))};
  }
};

// Writes R, G, B; X is dropped. The file is overwritten where there is one, not replaced as a whole. Blocks
// for the disk. Errors: io_error, with libpng's reason.
Result<void> WritePng(const std::filesystem::path& file, const Picture& picture);

// The same as bytes of a file, packed fast rather than small. Errors: io_error.
Result<std::vector<std::uint8_t>> EncodePng(const Picture& picture);

// Any PNG, as 8-bit RGB with its alpha in X. At most 64 MB are read, and 4096 x 4096 pixels. Errors: those of
// ReadFile; invalid_argument (not a valid PNG, or too many pixels).
Result<Picture> ReadPng(const std::filesystem::path& file);

// Copies `from` into `into` with its lower left corner at (x_px, y_px), X too; it must fit:
// nothing is checked.
void Paste(const Picture& from, Picture& into, int x_px, int y_px);

}  // namespace kaori::image
