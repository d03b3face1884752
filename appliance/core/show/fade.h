// How faces and expressions come and go when a person calls them: each may have times and a curve of its own.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace kaori::show {

inline constexpr float kLongestItemFade_s = 1800;  // Half an hour, as of cues.

// How the share of what comes grows over the time of its fade, from 0 to 1; what goes has the rest. Numbers stand in
// packs: new ones are added at the end.
enum class FadeCurve : std::uint32_t {
  kS,          // Soft at both ends.
  kLinear,     // Steady.
  kSlowStart,  // As a square: slow at first.
  kSlowEnd,    // The same from its other end.
};
// As files write them, in the order of FadeCurve.
inline constexpr std::array<std::string_view, 4> kFadeCurveNames{"s", "linear", "slow start", "slow end"};

// A time below 0: as the level `fade` says at the call. 0 is a cut.
struct ItemFade {
  float in_s = -1;   // From the call until it is there,
  float out_s = -1;  // and, where it was a toggle or a button held down, until it is gone again.
  FadeCurve curve = FadeCurve::kS;
  friend bool operator==(const ItemFade&, const ItemFade&) = default;
};

}  // namespace kaori::show
