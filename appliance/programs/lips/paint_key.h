// Which chroma is paint: a wedge of the Cb/Cr plane, made once from the paint's colour.
#pragma once

#include <array>
#include <cstdint>

namespace kaori::lips {

// sRGB, as a colour picker shows it.
struct Paint {
  std::uint8_t red = 20;
  std::uint8_t green = 60;
  std::uint8_t blue = 200;
  friend bool operator==(const Paint&, const Paint&) = default;
};

// Thousandths of the chroma plane's side, as in the chroma key of OBS.
struct KeySettings {
  float similarity = 140;  // How far a colour may lie from the paint's: more takes more for paint.
  float smoothness = 80;   // The width of the soft edge round that.
  float spill = 80;        // What is tinted less than this is paint's light on skin and teeth, not paint.
  friend bool operator==(const KeySettings&, const KeySettings&) = default;
};

// Chroma about neutral, in levels: -128 .. 127.
struct Chroma {
  float cb = 0;
  float cr = 0;
};

// ITU-R BT.601, full range.
Chroma ChromaOf(Paint paint);

// A half of the chroma plane: cb * x + cr * y + offset >= 0, with a normal 64 long.
struct HalfPlane {
  std::int16_t cb = 0;
  std::int16_t cr = 0;
  std::int16_t offset = 0;
};

// In bright light and in shade a paint keeps its hue and changes its saturation. So a colour is brought to
// the paint's own saturation before it is compared: paint is a wedge with its point at neutral, cut off at
// the spill. Luma does not count: half a mouth in shadow is still a mouth.
class PaintKey {
 public:
  explicit PaintKey(Paint paint, const KeySettings& settings = {});

  // How far inside the wedge a colour lies, in levels; negative outside. Bytes as a camera sends them.
  float Depth(std::uint8_t cb, std::uint8_t cr) const;

  // The soft key: 0 not paint .. 1 paint, 0.5 at the wedge's edge.
  float Soft(std::uint8_t cb, std::uint8_t cr) const;

  // Paint, or nearly so: within the soft edge.
  bool at(std::uint8_t cb, std::uint8_t cr) const;

  // What is nearly paint lies in all three.
  const std::array<HalfPlane, 3>& weak() const { return weak_; }

 private:
  std::array<HalfPlane, 3> weak_;
  float smooth_levels_;
};

}  // namespace kaori::lips
