// Reads a camera frame of any format as planes of brightness and colour.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "drivers/base/result.h"
#include "drivers/ports/camera.h"

namespace kaori::decode {

// One of Y, Cb, Cr: 8-bit samples, row 0 on top. The arguments of `at` must satisfy 0 <= x <
// width_px and 0 <= y < height_px: nothing is checked for a single sample, since the reader of
// the frame has checked that all of them lie within `bytes`.
struct Plane {
  // From the first sample on; samples of other planes may lie between.
  std::span<const std::uint8_t> bytes;
  // In samples of this plane, which may be fewer than the picture's.
  int width_px = 0;
  int height_px = 0;
  std::uint32_t stride_bytes = 0;  // From a row to the next.
  std::uint32_t step_bytes = 1;    // From a sample to the next: packed formats interleave.

  // Not checked: x and y lie within the plane.
  std::uint8_t at(int x, int y) const {
    return bytes[static_cast<std::size_t>(y) * stride_bytes + static_cast<std::size_t>(x) * step_bytes];
  }
};

// Y, Cb and Cr of BT.601; 128 is neutral colour. The colour planes cover the same picture as
// Y, with as many samples or fewer: sample (x, y) of Cb lies at (x * y.width_px /
// cb.width_px, ...) of Y. Borrowed from a frame or a reader.
struct Planes {
  // Of the whole picture's size.
  Plane y;
  Plane cb;
  Plane cr;
  bool full_range = false;  // Y: true 0..255 (JPEG), false 16..235 (video).
};

// Uncompressed frames are read in place. JPEG is decompressed into the reader's own memory, which it
// keeps for the next frame: after the first frames nothing is allocated. One thread. Any bytes are
// borne: they come from a camera that may lie about its size, or from a cable that drops half a frame.
class PlaneReader {
 public:
  PlaneReader();
  PlaneReader(PlaneReader&&) noexcept;
  PlaneReader& operator=(PlaneReader&&) noexcept;
  ~PlaneReader();

  // Blocks for some milliseconds where a JPEG is decompressed. The result borrows from `frame`, or from
  // this reader until its next Read; so both must outlive it. Errors:
  //   bad_message  the frame has fewer bytes than its format needs, or is no JPEG of its format's size; the
  //                attempt says which
  Result<Planes> Read(const ports::CameraFrame& frame);

 private:
  // libjpeg-turbo's decompressor with the memory that it fills.
  class Jpeg;
  // Decompresses into the reader's own memory. Errors: as Read.
  Result<Planes> ReadJpeg(const ports::CameraFrame& frame);

  std::unique_ptr<Jpeg> jpeg_;  // Made at the first JPEG.
};

}  // namespace kaori::decode
