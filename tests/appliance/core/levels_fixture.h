// A performance whose levels are looked at: two sticks that answer, and roles that both have the head's yaw.
#pragma once

#include <algorithm>
#include <cmath>

#include "appliance/core/performance/levels.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {

using show::Control;
using show::Device;
using show::Level;
using show::Takeover;

inline show::RoleMap Map(Control control, Level level, Takeover takeover = Takeover::kJump) {
  const auto& info = show::InfoOf(level);
  return {.control = control, .level = level, .from = info.low, .to = info.high, .takeover = takeover};
}

class LevelsTest : public PerformanceTest {
 protected:
  LevelsTest() {
    Live();
    SetKnob(Knob::kMouth, 0);
  }

  // Two roles on the two sticks that both have the head's yaw; the second has the slider on Life besides.
  void TwoSticks(Takeover takeover = Takeover::kJump) {
    show_.roles.roles = {
        {.name = "one", .device = Device::kLeftStick, .maps = {Map(Control::kX, Level::kHeadYaw)}},
        {.name = "two",
         .device = Device::kRightStick,
         .maps = {Map(Control::kSlider, Level::kLife, takeover), Map(Control::kX, Level::kHeadYaw)}}};
    BeginLevels(state_, show_.roles);
  }
  board::Stick& Stick(std::size_t which) { return board_.sticks[which].value; }
  const LevelNow& Now(Level level) const { return state_.levels[static_cast<std::size_t>(level)]; }
  float Value(Level level) const { return Now(level).value; }
  // Of the level's range.
  float Share(Level level, float difference) const {
    return std::abs(difference) / (show::InfoOf(level).high - show::InfoOf(level).low);
  }
  // The largest step of the level within a second of frames of a 60th, of its range.
  float LargestStep(Level level) {
    float largest = 0;
    for (int i = 0; i < 60; ++i) {
      const float before = Value(level);
      Step();
      largest = std::max(largest, Share(level, Value(level) - before));
    }
    return largest;
  }
};

}  // namespace kaori::performance
