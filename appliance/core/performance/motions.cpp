#include "appliance/core/performance/motions.h"

#include <algorithm>

#include "appliance/core/performance/ease.h"

namespace kaori::performance {
namespace {

// MotionSound of the lip program fades the sound of a motion that is cut off in the same time.
constexpr float kFadeOut_s = 0.25F;

// Between two keys the value eases in and out; before the first and after the last it is 0.
float At(const show::MotionCurve& curve, float at_s) {
  const auto next = std::ranges::upper_bound(curve.keys, at_s, {}, &show::MotionKey::at_s);
  if (next == curve.keys.begin() || next == curve.keys.end()) return 0;
  const show::MotionKey& a = *(next - 1);
  const float t = (at_s - a.at_s) / std::max(1e-6F, next->at_s - a.at_s);
  return Mix(a.value, next->value, SmoothStep(t));
}

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

}  // namespace

// A motion lasts as long as its longest curve or its sound, so that its last word is not cut off.
float EndOf(const show::Motion& motion) {
  const auto frames =
      static_cast<float>(motion.sound.samples.size()) / static_cast<float>(motion.sound.channels);
  float end_s = frames / static_cast<float>(show::kSoundRate_hz);
  for (const auto& curve : motion.curves) end_s = std::max(end_s, curve.keys.back().at_s);
  return end_s;
}

// By time, since voices are taken wherever one is free. Of two that began in one frame the
// first in the list counts.
const Playing* Youngest(const State& state) {
  const Playing* youngest = nullptr;
  for (const Playing& voice : state.voices)
    if (voice.motion >= 0 && (youngest == nullptr || voice.at_s < youngest->at_s)) youngest = &voice;
  return youngest;
}

// A voice whose motion the show has not (a state of another show) plays nothing. A motion that began to fade
// out goes on doing so, even where the one that took over has ended since: gain < 1 says so.
Motion PlayMotions(State& state, const show::Show& show, float dt_s) {
  Motion sum;
  const Playing* youngest = Youngest(state);
  for (Playing& voice : state.voices) {
    if (voice.motion < 0 || voice.motion >= static_cast<int>(show.motions.size())) continue;
    const show::Motion& played = show.motions[static_cast<std::size_t>(voice.motion)];
    voice.at_s += dt_s;
    if (&voice != youngest || voice.gain < 1) voice.gain = Travel(voice.gain, 0, dt_s, 1 / kFadeOut_s);
    for (const auto& curve : played.curves) Add(sum, curve, voice.gain * At(curve, voice.at_s));
    if (voice.gain <= 0 || voice.at_s >= EndOf(played)) voice.motion = -1;
  }
  return sum;
}

}  // namespace kaori::performance
