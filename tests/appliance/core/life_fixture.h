// A performance that lives by itself, and what is measured of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "appliance/core/performance/aim.h"
#include "appliance/core/performance/blinking.h"
#include "appliance/core/performance/life.h"
#include "appliance/core/performance/saccade.h"
#include "render/scene/view.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {

inline constexpr std::uint16_t kWinks = 9;  // An expression that shuts the left lid.
inline constexpr std::int32_t kVisitor = 1, kWing = 2;

class LifeTest : public PerformanceTest {
 protected:
  LifeTest() {
    show_.cast.expressions[kWinks].lids = {1, 0};
    show_.cast.neck_pivot = {0, -0.09F, -0.02F};
    show_.gaze_targets = {
        {show::kHouseName, {0, 0, 4}}, {"seat 12", {-1.2F, -0.6F, 5}}, {"wing", {2, 0.2F, 3}}};
    show_.motions.push_back(
        {.name = "doze",
         .key_usage = 0x20,
         .curves = {{show::MotionTarget::kLids, 0, {{0, 0}, {0.3F, 0.5F}, {9, 0.5F}, {9.5F, 0}}}}});
    state_ = Opening(show_, board_, now_);
    SetKnob(Knob::kLife, kLifeAsPeople);
    Live();
  }

  void Speak(float level_db) {
    board_.voice.source = board::SourceState::kLive;
    board_.voice.value.speaking = level_db > -50 ? 1 : 0;
    board_.voice.value.level_db = level_db;
    board_.voice.value.height = level_db > -50 ? 0.4F : 0.0F;
  }
  const scene::Scene& Frame(Duration by = kFrame) {
    board_.voice.at = now_ + by;
    return Step(by);
  }

  // Where an eye, 0 the left, looks in the stage: yaw and pitch.
  glm::vec2 InStage(std::size_t eye) const {
    const scene::Gaze& gaze = performed_.scene.gaze[eye];
    return AnglesOf(scene::TurnOf(performed_.scene.head) * DirectionOf({gaze.yaw_rad, gaze.pitch_rad}));
  }
  // How far an eye looks past a point of the stage, by where that eye is in this frame.
  float Off_rad(std::size_t eye, glm::vec3 point_m) const {
    const scene::Head& head = performed_.scene.head;
    const glm::vec3 at_rest{eye == 0 ? 0.0315F : -0.0315F, 0, 0.052F};
    const glm::vec3 pivot = show_.cast.neck_pivot;
    const glm::vec3 eye_m = scene::TurnOf(head) * (at_rest - pivot) + pivot + head.shift_m;
    const glm::vec3 looks = DirectionOf(InStage(eye));
    return std::acos(std::min(1.0F, glm::dot(looks, glm::normalize(point_m - eye_m))));
  }

  // When blinks began within so long, in seconds.
  std::vector<double> Blinks(Duration time) {
    std::vector<double> begun;
    bool shut = false;
    const Time from = now_;
    while (now_ < from + time) {
      const auto& lids = Frame().weights.lids_shut;
      const bool now_shut = std::max(lids[0], lids[1]) > 0.5F;
      if (now_shut && !shut) begun.push_back(Seconds(now_ - from));
      shut = now_shut;
    }
    return begun;
  }
  double PerMinute(Duration time) { return static_cast<double>(Blinks(time).size()) * 60 / Seconds(time); }

  // Both eyes' mean direction in the stage, `hz` times a second, of which every `keep`-th is kept.
  std::vector<glm::vec2> Trace(int hz, int keep, double seconds) {
    std::vector<glm::vec2> trace;
    const Duration frame = std::chrono::nanoseconds(1'000'000'000 / hz);
    for (int n = 1; n <= static_cast<int>(seconds * hz); ++n) {
      Frame(frame);
      if (n % keep == 0) trace.push_back((InStage(0) + InStage(1)) * 0.5F);
    }
    return trace;
  }
};

inline float Degrees(float rad) {
  return rad / show::kDegree;
}

}  // namespace kaori::performance
