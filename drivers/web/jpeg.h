// Encodes pictures as JPEG.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "drivers/base/result.h"

namespace kaori::web {

// A picture of 8-bit R, G, B, X; rows without padding. Borrowed.
struct Picture {
  // In pixels; at least 1 and at most 8192 a side.
  int width_px = 0;
  int height_px = 0;
  std::span<const std::uint8_t> rgbx;
  bool bottom_up = true;  // The bottom row comes first, as in ports::PixelMemory.
};

// Keeps its memory from picture to picture. One thread. Pictures are subsampled to half the colour
// (4:2:0) and transformed fast: they are for looking at, not for measuring.
class JpegEncoder {
 public:
  JpegEncoder();
  ~JpegEncoder();

  // `quality` is 1..100. Blocks until the picture is encoded: some milliseconds for a megapixel. Errors:
  // invalid_argument (sizes and bytes do not agree, or a side is longer than 8192 pixels),
  // not_enough_memory (whatever the library says).
  Result<std::string> Encode(const Picture& picture, int quality);

 private:
  struct Close {
    void operator()(void* handle) const;
  };
  // The compressor of libjpeg-turbo; null where it could not be made.
  std::unique_ptr<void, Close> handle_;
  unsigned char* buffer_ = nullptr;  // Allocated by the library, and grown as needed.
  // What the buffer holds at most.
  unsigned long buffer_bytes_ = 0;
};

}  // namespace kaori::web
