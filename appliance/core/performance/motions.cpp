#include "appliance/core/performance/motions.h"

#include <algorithm>
#include <cmath>

#include "appliance/core/performance/ease.h"
#include "appliance/core/performance/layers.h"

namespace kaori::performance {
namespace {

// MotionSound of the lip program fades the sound of a motion that is cut off in the same time.
constexpr float kFadeOut_s = 0.25F;
constexpr float kLeavesGain = 0.999F;  // Below 1 a motion fades out by itself.

// Angles of all motions add up. Nothing limits the sum: head and gaze may go further than a stick takes them.
void Add(Motion& motion, const show::MotionCurve& curve, float value) {
  switch (curve.target) {
    case show::MotionTarget::kHeadYaw:
      motion.head.yaw_rad += value;
      break;
    case show::MotionTarget::kHeadPitch:
      motion.head.pitch_rad += value;
      break;
    case show::MotionTarget::kHeadRoll:
      motion.head.roll_rad += value;
      break;
    case show::MotionTarget::kHeadLean:
      motion.head.shift_m.z += value;
      break;
    case show::MotionTarget::kGazeYaw:
      motion.gaze.yaw_rad += value;
      break;
    case show::MotionTarget::kGazePitch:
      motion.gaze.pitch_rad += value;
      break;
    case show::MotionTarget::kLids:
      motion.lids += value;
      break;
    case show::MotionTarget::kChannel:
      motion.channels.Add(curve.channel, value);
      break;
  }
}

// Where a loop is at this time: it goes on at its beginning. What was cut off at the end counts there, so
// that it keeps its time.
float InLoop(const show::Motion& motion, float at_s) {
  if (at_s < motion.loop_to_s) return at_s;
  return motion.loop_from_s + std::fmod(at_s - motion.loop_from_s, motion.loop_to_s - motion.loop_from_s);
}

}  // namespace

// A motion lasts as long as its longest curve or its sound, so that its last word is not cut off.
float EndOf(const show::Motion& motion) {
  const auto frames =
      static_cast<float>(motion.sound.samples.size()) / static_cast<float>(motion.sound.channels);
  float end_s = frames / static_cast<float>(show::kSoundRate_hz);
  for (const auto& curve : motion.curves) end_s = std::max(end_s, curve.keys.back().at_s);
  return end_s;
}

// By time, since voices are taken wherever one is free; of two that began in one frame the first in the list
// counts. One that fades out is older than one that does not, whatever its time: a loop begins anew while it
// fades out.
const Playing* Youngest(const State& state) {
  const auto is_younger = [](const Playing& a, const Playing& b) {
    return (a.gain < 1) != (b.gain < 1) ? b.gain < 1 : a.at_s < b.at_s;
  };
  const Playing* youngest = nullptr;
  for (const Playing& voice : state.voices)
    if (voice.motion >= 0 && (youngest == nullptr || is_younger(voice, *youngest))) youngest = &voice;
  return youngest;
}

bool IsPlaying(const State& state, std::int32_t motion) {
  return std::ranges::any_of(state.voices,
                             [=](const Playing& v) { return v.motion == motion && v.gain >= 1; });
}

void EndMotion(State& state, std::int32_t motion) {
  for (Playing& voice : state.voices)
    if (voice.motion == motion) voice.gain = std::min(voice.gain, kLeavesGain);
}

// A gain just below 1 is what PlayMotions fades out from.
void EndMotions(State& state) {
  for (Playing& voice : state.voices) voice.gain = std::min(voice.gain, kLeavesGain);
}

// A voice whose motion the show has not (a state of another show) plays nothing. A motion that began to fade
// out goes on doing so, even where the one that took over has ended since: gain < 1 says so.
Motion PlayMotions(State& state, const show::Show& show, float dt_s) {
  Motion sum;
  ClearLayers(state);
  const Playing* youngest = Youngest(state);
  for (Playing& voice : state.voices) {
    if (voice.motion < 0 || voice.motion >= static_cast<int>(show.motions.size())) continue;
    const show::Motion& played = show.motions[static_cast<std::size_t>(voice.motion)];
    voice.at_s += dt_s;
    if (played.Loops()) voice.at_s = InLoop(played, voice.at_s);
    if (&voice != youngest || voice.gain < 1) voice.gain = Travel(voice.gain, 0, dt_s, 1 / kFadeOut_s);
    for (const auto& curve : played.curves) {
      const float value = voice.gain * show::ValueAt(curve.keys, played.recorded, voice.at_s);
      Add(sum, curve, value * LayerShare(state, show, curve, voice, value));
    }
    if (voice.gain <= 0 || (!played.Loops() && voice.at_s >= EndOf(played))) voice.motion = -1;
  }
  return sum;
}

}  // namespace kaori::performance
