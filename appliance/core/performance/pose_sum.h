// What several sources do to head and eyes adds up.
#pragma once

#include "render/scene/scene.h"

namespace kaori::performance {

// Operator input, life and motions, in this order. Angles are added one by one, as small turns may
// be; nothing limits the sum.
inline scene::Head Sum(const scene::Head& a, const scene::Head& b, const scene::Head& c) {
  return {a.yaw_rad + b.yaw_rad + c.yaw_rad, a.pitch_rad + b.pitch_rad + c.pitch_rad,
          a.roll_rad + b.roll_rad + c.roll_rad, a.shift_m + b.shift_m + c.shift_m};
}

inline scene::Gaze Sum(const scene::Gaze& a, const scene::Gaze& b, const scene::Gaze& c) {
  return {a.yaw_rad + b.yaw_rad + c.yaw_rad, a.pitch_rad + b.pitch_rad + c.pitch_rad};
}

}  // namespace kaori::performance
