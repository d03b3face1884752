// Draws what the lip camera sees: the lower half of a face, and a mouth painted blue. Pure functions on YUYV.
#pragma once

#include <cstdint>
#include <span>

namespace kaori::sim {

// 4 bytes hold two pixels: Y Cb Y Cr, BT.601 of limited range. Width is even; bytes = width * height * 2.
struct YuyvPicture {
  // Even: two pixels share their colour.
  int width_px = 0;
  int height_px = 0;
  // Row 0 on top, without padding.
  std::span<std::uint8_t> bytes;
};

// The face without its mouth: skin, the shadow under the nose, the chin, a dark room
// beside it. Overwrites all of `into`.
void PaintFace(const YuyvPicture& into);

// Width of the painted mouth at rest as a part of the picture's width.
inline constexpr double kRestMouthOfPicture = 0.28;

// Sizes of the paint's outline, in widths of the mouth at rest; what is higher than shut lips opens between
// them.
struct Mouth {
  // Between the outer edges of the painted lips.
  double height = 0.25;
  // From corner to corner of the painted lips.
  double width = 1;
  friend bool operator==(const Mouth&, const Mouth&) = default;
};
// Paints over the face that is there, with smooth edges. The middle of the mouth does not move.
void PaintMouth(const Mouth& mouth, const YuyvPicture& into);

// Adds the sensor's noise of frame `sequence` to `from`, up to 3 steps; the same number gives the same
// noise. Values must be 3 to 252, or they run over. `into` is as long as `from` and may be the same.
void AddNoise(std::span<const std::uint8_t> from, std::uint32_t sequence, std::span<std::uint8_t> into);

// Nothing but noise.
void FillWithNoise(std::uint32_t sequence, std::span<std::uint8_t> into);

}  // namespace kaori::sim
