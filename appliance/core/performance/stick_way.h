// Where the controls of a stick stand, by their names in roles.
#pragma once

#include "appliance/core/board/sections.h"
#include "appliance/core/show/roles.h"

namespace kaori::performance {

// -1 to 1 of what springs back, 0 to 1 of the slider. Of the hat: up and right are 1, down and left -1, and between two of them it
// says neither. A dial has no way: it only turns. Pure.
inline float WayOn(const board::Stick& stick, show::Control control) {
  const auto hat = [&stick](std::int32_t one, std::int32_t other) {
    if (stick.hat == one) return 1.0F;
    return stick.hat == other ? -1.0F : 0.0F;
  };
  switch (control) {
    case show::Control::kX:
      return stick.x;
    case show::Control::kY:
      return stick.y;
    case show::Control::kTwist:
      return stick.twist;
    case show::Control::kHatX:
      return hat(2, 6);
    case show::Control::kHatY:
      return hat(0, 4);
    case show::Control::kSlider:
      return stick.slider;
    case show::Control::kDial:
      break;
  }
  return 0;
}

}  // namespace kaori::performance
