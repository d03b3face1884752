#include "appliance/programs/lips/paint_key.h"

#include <algorithm>
#include <cmath>

namespace kaori::lips {
namespace {

constexpr float kPaintKeyLevelsPerThousandth = 0.255F;
constexpr float kNormal = 64;   // The length of a half plane's normal, with which sums stay within 16 bits.
constexpr float kWeak = 0.25F;  // A colour outside by less than this part of the soft edge is nearly paint.
constexpr float kPaintKeyMinTint = 6;  // Levels. Neutral is never paint, whatever the settings are.
constexpr float kGreyPaint = 20;       // Levels. A colour of less saturation cannot be a paint.
constexpr float kNoise = 3;            // Levels by which the wedge's point is blunted.
// The wedge's half angle lies between 6 and 76 degrees: a narrower one holds no paint in changing light, and
// a wider one is a half plane.
constexpr float kMinTangent = 0.1F;
constexpr float kMaxTangent = 4;

// The normal is scaled to a length of 64 and rounded; an offset is in levels before that.
HalfPlane Half(float cb, float cr, float offset) {
  const float scale = kNormal / std::hypot(cb, cr);
  const auto whole = [](float value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -16000.0F, 16000.0F)));
  };
  return {whole(cb * scale), whole(cr * scale), whole(offset * kNormal)};
}

int Side(const HalfPlane& half, std::uint8_t cb, std::uint8_t cr) {
  return half.cb * (cb - 128) + half.cr * (cr - 128) + half.offset;
}

// How far inside of the wedge a colour is: the least distance to its three sides, in 64ths of a level.
int LeastSide(const std::array<HalfPlane, 3>& halves, std::uint8_t cb, std::uint8_t cr) {
  return std::min({Side(halves[0], cb, cr), Side(halves[1], cb, cr), Side(halves[2], cb, cr)});
}

}  // namespace

// The full-range matrix of JFIF, whose coefficients are those of BT.601.
Chroma ChromaOf(Paint paint) {
  const auto r = static_cast<float>(paint.red);
  const auto g = static_cast<float>(paint.green);
  const auto b = static_cast<float>(paint.blue);
  return {-0.168736F * r - 0.331264F * g + 0.5F * b, 0.5F * r - 0.418688F * g - 0.081312F * b};
}

// Side 0 cuts off what has too little tint along the paint's direction; sides 1 and 2 are the wedge's flanks,
// whose tangent to the paint's direction is similarity over saturation: a paler paint needs a wider wedge for
// the same distance. `soft` moves all of them outwards, so that the bits hold the soft edge too. A paint
// without a hue has no wedge: its side 0 lies beyond every colour.
PaintKey::PaintKey(Paint paint, const KeySettings& settings)
    : smooth_levels_(std::max(settings.smoothness * kPaintKeyLevelsPerThousandth, 1.0F)) {
  const Chroma want = ChromaOf(paint);
  const float saturation = std::hypot(want.cb, want.cr);
  const bool grey = saturation < kGreyPaint;
  const Chroma along = grey ? Chroma{1, 0} : Chroma{want.cb / saturation, want.cr / saturation};
  const float tangent =
      std::clamp(settings.similarity * kPaintKeyLevelsPerThousandth / std::max(saturation, 1.0F), kMinTangent,
                 kMaxTangent);
  const float soft = smooth_levels_ * kWeak;
  const float least = std::max(settings.spill * kPaintKeyLevelsPerThousandth - soft, kPaintKeyMinTint);
  weak_[0] = Half(along.cb, along.cr, grey ? -200 : -least);
  weak_[1] = Half(tangent * along.cb - along.cr, tangent * along.cr + along.cb, kNoise + soft / 2);
  weak_[2] = Half(tangent * along.cb + along.cr, tangent * along.cr - along.cb, kNoise + soft / 2);
}

float PaintKey::Depth(std::uint8_t cb, std::uint8_t cr) const {
  return static_cast<float>(LeastSide(weak_, cb, cr)) / kNormal - smooth_levels_ * kWeak;
}

float PaintKey::Soft(std::uint8_t cb, std::uint8_t cr) const {
  return std::clamp(0.5F + Depth(cb, cr) / smooth_levels_, 0.0F, 1.0F);
}

bool PaintKey::at(std::uint8_t cb, std::uint8_t cr) const {
  return LeastSide(weak_, cb, cr) >= 0;
}

}  // namespace kaori::lips
