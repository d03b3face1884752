#include "hw-sim/devices/lip_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace kaori::sim {
namespace {

// BT.601 in the limited range, as floats: only the result is rounded.
struct Colour {
  float y;
  float cb;
  float cr;
};
// BT.601 of sRGB (205, 150, 120), (40, 80, 200), (60, 20, 25) and (30, 32, 36).
constexpr Colour kSkin{156, 107, 154};
constexpr Colour kPaint{86, 187, 102};
constexpr Colour kThroat{40, 121, 141};
constexpr Colour kRoom{43, 130, 127};

// Where things are, in parts of the picture; y runs down. The lips' reader finds the mouth by its
// colour, so the place matters only for whoever looks.
constexpr double kMouthX = 0.5;
constexpr double kMouthY = 0.52;
constexpr double kNoseY = 0.16;

// The lips themselves, in widths of the mouth at rest: what is left of the outline is the opening.
constexpr double kLipsHeight = 0.24;
constexpr double kOpeningOfWidth = 0.74;

// Noise is cut from a table, which is faster than a hash for each byte of a frame.
constexpr std::size_t kNoiseBytes = 1 << 16;

std::uint32_t Scatter(std::uint32_t x) {  // The finaliser of MurmurHash3.
  x = (x ^ (x >> 16)) * 0x85EBCA6Bu;
  x = (x ^ (x >> 13)) * 0xC2B2AE35u;
  return x ^ (x >> 16);
}

// The same table in every run.
std::array<std::uint8_t, kNoiseBytes> MakeNoise() {
  std::array<std::uint8_t, kNoiseBytes> noise;
  for (std::size_t n = 0; n < noise.size(); ++n) {
    const std::uint32_t random = Scatter(static_cast<std::uint32_t>(n) + 1);
    // The sum of two even distributions of 0..3: 0..6, 3 in the mean, near enough to a bell.
    noise[n] = static_cast<std::uint8_t>((random & 3u) + ((random >> 2) & 3u));
  }
  return noise;
}

// A hill of height 1 whose sides fall off within `width`.
float Bump(double distance, double width) {
  return static_cast<float>(std::exp(-(distance * distance) / (width * width)));
}

// `part` 0 is a, 1 is b.
Colour Mix(const Colour& a, const Colour& b, float part) {
  return {a.y + (b.y - a.y) * part, a.cb + (b.cb - a.cb) * part, a.cr + (b.cr - a.cr) * part};
}

// Colour of the face at (x, y), parts of the picture.
Colour FaceAt(double x, double y) {
  const double side = std::abs(x - kMouthX) / (0.40 - 0.10 * y * y);  // 1 on the cheek's outline.
  const float outside = static_cast<float>(std::clamp((side - 0.97) / 0.06, 0.0, 1.0));
  if (outside >= 1) return kRoom;
  Colour skin = kSkin;
  skin.y *= 1.04F - 0.22F * static_cast<float>(side * side);
  skin.y -= 34 * Bump(std::hypot(x - kMouthX, (y - kNoseY) * 2.2), 0.10);  // Under the nose,
  skin.y -= 16 * Bump((y - 0.80) * 4, 0.35) * Bump(x - kMouthX, 0.14);     // above the chin,
  skin.y += 14 * Bump(std::hypot(x - kMouthX, y - 0.90), 0.10);            // and its light.
  return Mix(skin, kRoom, outside);
}

// Within what AddNoise can change by 3 without running over.
std::uint8_t Byte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 8.0F, 247.0F)));
}

// The mouth in pixels, and for a column the rows between which its parts lie.
struct MouthPixels {
  double centre_x;
  double centre_y;
  double half_width;
  double half_height;
  double half_opening_width;
  double half_opening_height;
};

MouthPixels MouthIn(const Mouth& mouth, const YuyvPicture& picture) {
  const double rest_px = kRestMouthOfPicture * picture.width_px;
  const double opening = std::max(0.0, mouth.height - kLipsHeight);
  return {kMouthX * picture.width_px,
          kMouthY * picture.height_px,
          mouth.width * rest_px / 2,
          mouth.height * rest_px / 2,
          kOpeningOfWidth * mouth.width * rest_px / 2,
          opening * rest_px / 2};
}

// Half the height of a lens with pointed corners, `from_centre` away from its middle.
double LensHalf(double half_height, double half_width, double from_centre) {
  const double part = from_centre / half_width;
  return half_width <= 0 || std::abs(part) >= 1 ? -1 : half_height * std::pow(1 - part * part, 0.75);
}

// How much of the pixel at `from_centre` rows lies within `half`, 0 .. 1. A pixel is one row high: its
// coverage runs from 0 to 1 as the edge passes it, which gives smooth edges.
float Covered(double half, double from_centre) {
  return static_cast<float>(std::clamp(half - std::abs(from_centre) + 0.5, 0.0, 1.0));
}

struct Column {
  double lips = -1;     // Half heights in pixels;
  double opening = -1;  // negative: not in this column.
};

// Two pixels share Cb and Cr: each is mixed by itself, and the mean of both colours is stored.
void PaintPixelPair(std::span<std::uint8_t> pair, double row, const Column& left, const Column& right) {
  std::array<float, 2> paint{Covered(left.lips, row), Covered(right.lips, row)};
  const std::array<float, 2> throat{Covered(left.opening, row), Covered(right.opening, row)};
  if (paint[0] + paint[1] <= 0) return;
  float cb = 0;
  float cr = 0;
  for (std::size_t n = 0; n < 2; ++n) {
    const Colour skin{static_cast<float>(pair[2 * n]), static_cast<float>(pair[1]),
                      static_cast<float>(pair[3])};
    const Colour colour = Mix(Mix(skin, kPaint, paint[n]), kThroat, std::min(throat[n], paint[n]));
    pair[2 * n] = Byte(colour.y);
    cb += colour.cb / 2;
    cr += colour.cr / 2;
  }
  pair[1] = Byte(cb);
  pair[3] = Byte(cr);
}

// What depends on the column alone is worked out once for all rows.
std::vector<Column> Columns(const MouthPixels& mouth, int first, int end) {
  std::vector<Column> columns(static_cast<std::size_t>(end - first));
  for (int x = first; x < end; ++x) {
    const double from_centre = x + 0.5 - mouth.centre_x;
    auto& column = columns[static_cast<std::size_t>(x - first)];
    column.lips = LensHalf(mouth.half_height, mouth.half_width, from_centre);
    if (mouth.half_opening_height > 0)
      column.opening = LensHalf(mouth.half_opening_height, mouth.half_opening_width, from_centre);
  }
  return columns;
}

}  // namespace

// Two pixels share their Cb and Cr (YUYV, 4:2:2), so that colours are taken between the two.
void PaintFace(const YuyvPicture& into) {
  std::size_t at = 0;
  for (int y = 0; y < into.height_px; ++y) {
    for (int x = 0; x < into.width_px; x += 2) {
      const double v = (y + 0.5) / into.height_px;
      const Colour pair = FaceAt(static_cast<double>(x + 1) / into.width_px, v);
      for (const float value : {pair.y, pair.cb, pair.y, pair.cr}) into.bytes[at++] = Byte(value);
    }
  }
}

// Paints over a face that PaintFace has painted; pixels beyond the mouth's box stay.
void PaintMouth(const Mouth& shape, const YuyvPicture& into) {
  const MouthPixels mouth = MouthIn(shape, into);
  // An even column begins a pair; the margin is for half-covered pixels.
  const int first = std::max(0, static_cast<int>(mouth.centre_x - mouth.half_width - 1)) & ~1;
  const int end = std::min(into.width_px, (static_cast<int>(mouth.centre_x + mouth.half_width + 3)) & ~1);
  const int top = std::max(0, static_cast<int>(mouth.centre_y - mouth.half_height - 1));
  const int bottom = std::min(into.height_px, static_cast<int>(mouth.centre_y + mouth.half_height + 2));
  const std::vector<Column> columns = Columns(mouth, first, end);
  for (int y = top; y < bottom; ++y) {
    const double row = y + 0.5 - mouth.centre_y;
    const auto line =
        into.bytes.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(into.width_px) * 2);
    for (int x = first; x < end; x += 2) {
      const auto n = static_cast<std::size_t>(x - first);
      PaintPixelPair(line.subspan(static_cast<std::size_t>(x) * 2, 4), row, columns[n], columns[n + 1]);
    }
  }
}

// Deterministic: the same sequence number gives the same grain.
void AddNoise(std::span<const std::uint8_t> from, std::uint32_t sequence, std::span<std::uint8_t> into) {
  static const auto noise = MakeNoise();
  constexpr std::size_t kChunk = 1024;
  for (std::size_t start = 0; start < from.size(); start += kChunk) {
    const std::size_t count = std::min(kChunk, from.size() - start);
    // The golden ratio's fraction of 2^32 spreads neighbouring sequence numbers over all 32 bits.
    const std::uint32_t random = Scatter(sequence * 0x9E3779B9u + static_cast<std::uint32_t>(start));
    const std::uint8_t* grain = noise.data() + random % (kNoiseBytes - kChunk);
    for (std::size_t n = 0; n < count; ++n)
      into[start + n] = static_cast<std::uint8_t>(from[start + n] + grain[n] - 3);
  }
}

void FillWithNoise(std::uint32_t sequence, std::span<std::uint8_t> into) {
  for (std::size_t n = 0; n < into.size(); ++n)
    into[n] =
        static_cast<std::uint8_t>(Scatter(sequence ^ (static_cast<std::uint32_t>(n) * 0x9E3779B9u)) >> 24);
}

}  // namespace kaori::sim
