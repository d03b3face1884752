// What the board's section `lips` says about a mouth: whether it can be used, and how open and wide it is.
// Performance, calibration, desk and status all ask here, so that they never disagree about a mouth.
#pragma once

#include <algorithm>

#include "appliance/core/board/sections.h"

namespace kaori::board {

// The quality (0..1, Lips::quality) from which on the face follows a measured mouth, this value included.
// Below it the voice has the mouth.
inline constexpr float kUsableMouth = 0.3F;
// The quality from which on a measured mouth is good enough to learn from it: a calibration, the mouth at
// rest. It is stricter, since what is learnt wrongly stays and what is followed wrongly is over at the next
// picture.
inline constexpr float kLearnableMouth = 0.5F;

// Neither looks at the section's SourceState, which callers do.
inline bool IsUsable(const Lips& lips) {
  return lips.quality >= kUsableMouth;
}
inline bool IsLearnable(const Lips& lips) {
  return lips.quality >= kLearnableMouth;
}

// The mouth within this operator's range.
struct MouthPosition {
  float open = 0;     // 0 shut .. 1 open.
  float wide = 0.5F;  // 0 pursed .. 0.5 at rest .. 1 stretched.
};

// Maps the measured height and width onto the operator's range. A mouth at rest, which is 1 wide, stands in
// the middle of `wide`, however much farther it goes one way than the other.
inline MouthPosition PositionOf(const Lips& lips) {
  // A range of less than a hundredth is widened to one, so that no calibration divides by zero.
  const auto fraction = [](float value, float low, float high) {
    return std::clamp((value - low) / std::max(high - low, 0.01F), 0.0F, 1.0F);
  };
  return {.open = fraction(lips.height, lips.shut, lips.open),
          .wide = lips.width < 1 ? 0.5F * fraction(lips.width, lips.narrow, 1)
                                 : 0.5F + 0.5F * fraction(lips.width, 1, lips.wide)};
}

}  // namespace kaori::board
