// What curves of motions and takes move, by the names that files give it.
#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <string_view>

#include "appliance/core/show/motion.h"

namespace kaori::authoring {

struct CurveName {
  std::string_view name;
  show::MotionTarget target;
  float unit = 1;               // What one of the file's unit is in radians or metres; 1: a weight.
  std::string_view words = {};  // Of the file's unit; empty: a weight of 0 to 1.
};
inline constexpr float kRadPerDegree = std::numbers::pi_v<float> / 180;
// All but channels, which have the names of their expressions.
inline constexpr std::array<CurveName, 7> kCurveNames{
    {{"head_yaw", show::MotionTarget::kHeadYaw, kRadPerDegree, "degrees"},
     {"head_pitch", show::MotionTarget::kHeadPitch, kRadPerDegree, "degrees"},
     {"head_roll", show::MotionTarget::kHeadRoll, kRadPerDegree, "degrees"},
     {"head_lean", show::MotionTarget::kHeadLean, 0.01F, "cm"},
     {"gaze_yaw", show::MotionTarget::kGazeYaw, kRadPerDegree, "degrees"},
     {"gaze_pitch", show::MotionTarget::kGazePitch, kRadPerDegree, "degrees"},
     {"lids", show::MotionTarget::kLids}}};

// Null where it is none of them; it may be a channel then.
inline const CurveName* CurveNamed(std::string_view name) {
  const auto* const found = std::ranges::find(kCurveNames, name, &CurveName::name);
  return found == kCurveNames.end() ? nullptr : found;
}

// Null for a channel.
inline const CurveName* CurveNameOf(show::MotionTarget target) {
  const auto* const found = std::ranges::find(kCurveNames, target, &CurveName::target);
  return found == kCurveNames.end() ? nullptr : found;
}

}  // namespace kaori::authoring
