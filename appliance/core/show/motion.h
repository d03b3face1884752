// A registered motion: curves over time, added to head, gaze and channels.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kaori::show {

inline constexpr float kLongestMotion_s = 600;
inline constexpr float kWidestMotion = 4;  // Radians, metres, or a weight: face::kHeaviest.
inline constexpr float kShortestLoop_s = 0.5F;
inline constexpr int kMostTakes = 8;  // That play at once, each at its full gain; one more ends the oldest.
inline constexpr float kLeastTakeGain = 0.1F, kMostTakeGain = 2;  // Of a take's file and of a cue.

enum class MotionTarget : std::uint8_t {
  kHeadYaw,
  kHeadPitch,
  kHeadRoll,
  kGazeYaw,
  kGazePitch,
  kLids,
  kChannel,
  kHeadLean,  // Towards the audience.
};
inline constexpr std::uint8_t kMotionTargetCount = 8;

// One point of a curve.
struct MotionKey {
  float at_s = 0;
  float value = 0;  // Radians, metres, or a weight.
};
struct MotionCurve {
  MotionTarget target = MotionTarget::kHeadYaw;
  std::uint16_t channel = 0;  // Index of Cast::expressions, where the target is a channel.
  // Times rise from 0 or later; the first value is 0, and the last one too unless the motion loops: nothing
  // jumps.
  std::vector<MotionKey> keys;
};
// The rate of every recorded sound: that of the loudspeaker, so that nothing is converted while a show plays.
inline constexpr int kSoundRate_hz = 48000;
// 16 bits a sample, frames one after the other; at most kLongestMotion_s long.
struct Sound {
  int channels = 1;                   // 1, or 2: left and right side by side.
  std::vector<std::int16_t> samples;  // Whole frames; none: no sound.
};
// Where a motion lies beside the others who have the same levels (show::Level); performance/layers.h has the order.
enum class MotionLayer : std::uint8_t {
  kAdd,    // It is added to whoever has them.
  kUnder,  // It plays where no hand, no remote control and no lips have them.
  kOver,   // It plays in place of a remote control, lips and voice; a hand has them at once all the same.
};
inline constexpr std::array<std::string_view, 3> kMotionLayerNames{"add", "under", "over"};

// How one call plays a motion, where it says more than its name.
struct MotionUse {
  std::optional<MotionLayer> layer{};  // Nothing: the motion's own.
  float gain = 1;                      // Times as large, kLeastTakeGain..kMostTakeGain.
  float from_s = 0;                    // Where it begins, in seconds of the motion as it is played.
  bool operator==(const MotionUse&) const = default;
};

// Called by a key, a button or a cue; up to kMostTakes play at once, each beside what the operators move, as its
// layer says.
struct Motion {
  std::string name;
  // HID keyboard usage that plays it; 0: no key does.
  std::uint16_t key_usage = 0;
  std::vector<MotionCurve> curves;
  Sound sound{};  // Begins when the curves do.
  // True: the keys are points of a movement that somebody made, and it goes on smoothly through them. False:
  // they are poses, and it comes to rest at each.
  bool recorded = false;
  // Of a motion that loops: from `loop_to_s` it goes on at `loop_from_s`, where every curve has the same
  // value, until something ends it. Both 0: it plays once.
  float loop_from_s = 0;
  float loop_to_s = 0;
  MotionLayer layer = MotionLayer::kAdd;

  bool Loops() const { return loop_to_s > loop_from_s; }
};

// When the last of a motion's curves and its sound have ended, in seconds from its beginning, so that its last
// word is not cut off. A loop has no such end.
float EndOf(const Motion& motion);

// A curve at a time; 0 before its first key, and from its last one on. `recorded` is that of the motion:
// false, the value eases in and out between two keys; true, it follows a cubic whose slope at each key is
// that of the parabola through the key and its neighbours (finite differences). Pure; the time is logarithmic
// in the number of keys.
float ValueAt(std::span<const MotionKey> keys, bool recorded, float at_s);

}  // namespace kaori::show
