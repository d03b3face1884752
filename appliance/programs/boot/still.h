// A picture that stands ready: read from a file of bytes, and laid over a screen of any size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kaori::boot {

// Borrows the bytes it was read from. Top row first; red, green and blue, 8 bits each, of sRGB.
struct Still {
  // Both sides are 1 .. 8192.
  int width_px = 0;
  int height_px = 0;
  std::span<const std::uint8_t> rgb;
};

// Reads a PPM ("P6", 255 steps, no comments). None where it is anything else, is cut short, or has a side of
// more than 8192 pixels.
std::optional<Still> ReadStill(std::span<const std::uint8_t> file);

// The picture of the last face (appliance/core/last_face); none where the file is torn, or of a show whose
// pack does not begin so.
std::optional<Still> ReadLastStill(std::span<const std::uint8_t> file,
                                   std::span<const std::uint8_t> pack_begin);

// A screen's memory: rows of 4 bytes a pixel (blue, green, red, nothing), `pitch_bytes` apart. Borrowed; the
// memory of a dumb buffer is slow to read and is only written.
struct ScreenMemory {
  std::uint8_t* bytes = nullptr;
  int width_px = 0;
  int height_px = 0;
  std::size_t pitch_bytes = 0;
};

// Fills the screen: the still's height becomes the screen's, its middle stays in the middle, and where the
// screen is wider its edges go on. Smooth. Bilinear; on a screen that is narrower than the still its sides
// are cut off. Allocates a few bytes for each column.
void LayStill(const Still& still, const ScreenMemory& screen);

}  // namespace kaori::boot
