// The chroma key: paint is a wedge of the Cb/Cr plane, computed once from the paint's colour.
#pragma once

#include <array>
#include <cstdint>

namespace kaori::lips {

// The colour of the paint in sRGB, as a colour picker shows it. The default is the blue theatre paint of the
// demo.
struct Paint {
  std::uint8_t red = 20;
  std::uint8_t green = 60;
  std::uint8_t blue = 200;
  friend bool operator==(const Paint&, const Paint&) = default;
};

// Thousandths of the chroma plane's side, as in the chroma key of OBS.
struct KeySettings {
  float similarity = 140;  // How far a colour may lie from the paint's; more counts more colours as paint.
  float smoothness = 80;   // The width of the soft edge around that.
  float spill = 80;        // A colour with less tint is the paint's reflection on skin or teeth.
  friend bool operator==(const KeySettings&, const KeySettings&) = default;
};

// Chroma relative to neutral, in levels: -128 .. 127.
struct Chroma {
  float cb = 0;
  float cr = 0;
};

// The chroma of a paint by ITU-R BT.601, full range. In levels, relative to neutral.
Chroma ChromaOf(Paint paint);

// A half of the chroma plane: cb * x + cr * y + offset >= 0, with a normal of length 64.
struct HalfPlane {
  std::int16_t cb = 0;
  std::int16_t cr = 0;
  std::int16_t offset = 0;
};

// In light and in shade a paint keeps its hue and changes its saturation. A colour is therefore scaled to the
// paint's saturation before it is compared: paint is a wedge whose point is neutral, cut off at the spill.
// Luma does not count, so that half a mouth in shadow is still a mouth. Immutable; any thread. Geometry in
// levels of chroma: the soft edge is `smoothness` wide and lies around the wedge, half in and half out.
class PaintKey {
 public:
  // Works the three sides out once; every setting is safe, within its range or not.
  explicit PaintKey(Paint paint, const KeySettings& settings = {});

  // How far inside the wedge a colour lies, in levels; negative outside. Bytes are those of a camera, 128 is
  // neutral.
  float Depth(std::uint8_t cb, std::uint8_t cr) const;

  // The soft key: 0 not paint .. 1 paint, 0.5 at the wedge's edge.
  float Soft(std::uint8_t cb, std::uint8_t cr) const;

  // Whether a colour is paint, or within the soft edge.
  bool at(std::uint8_t cb, std::uint8_t cr) const;

  // The half planes whose intersection holds every colour for which at() is true.
  const std::array<HalfPlane, 3>& weak() const { return weak_; }

 private:
  // The wedge with half of the soft edge around it: a colour is paint, or nearly so, on the positive side of
  // all three.
  std::array<HalfPlane, 3> weak_;
  // The width of the soft edge.
  float smooth_levels_;
};

}  // namespace kaori::lips
