#include "appliance/core/performance/motions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "appliance/core/performance/ease.h"
#include "appliance/core/performance/layers.h"

namespace kaori::performance {
namespace {

// MotionSound of the lip program fades the sound of a motion that is cut off in the same time.
constexpr float kFade_s = 0.25F;

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

// How many motions were called after this one: the counter may have wrapped.
std::uint32_t AgeOf(const State& state, const Playing& voice) {
  return state.motions_called - voice.number;
}

bool HasSound(const show::Show& show, std::int32_t motion) {
  return motion >= 0 && motion < static_cast<int>(show.motions.size()) &&
         !show.motions[static_cast<std::size_t>(motion)].sound.samples.empty();
}

// For one more than may play the oldest ends, and a loop only where nothing else plays: the cue list counts on those
// (show::Track).
void MakeRoom(State& state, const show::Show& show) {
  const auto plays = [](const Playing& v) { return v.motion >= 0 && v.ends == 0; };
  if (std::ranges::count_if(state.voices, plays) < show::kMostTakes) return;
  const auto rank = [&](const Playing& v) {
    const bool loops = show.motions[static_cast<std::size_t>(v.motion)].Loops();
    return std::pair(!loops, AgeOf(state, v));
  };
  Playing* oldest = nullptr;
  for (Playing& voice : state.voices)
    if (plays(voice) && (oldest == nullptr || rank(voice) > rank(*oldest))) oldest = &voice;
  if (oldest != nullptr) oldest->ends = 1;
}

// A free voice, or of those that end the one of which least is left: no more than show::kMostTakes do not end.
Playing& FreeVoice(State& state) {
  return *std::ranges::min_element(state.voices, {}, [](const Playing& v) {
    return v.motion < 0 ? -1.0F : v.ends != 0 ? v.gain : 2.0F;
  });
}

// From the strongest layer to the weakest, and within each from the youngest to the oldest.
std::array<Playing*, kVoices> StrongestFirst(State& state) {
  std::array<Playing*, kVoices> voices{};
  std::ranges::transform(state.voices, voices.begin(), [](Playing& v) { return &v; });
  std::ranges::sort(voices, [&state](const Playing* a, const Playing* b) {
    return std::pair(b->layer, AgeOf(state, *a)) < std::pair(a->layer, AgeOf(state, *b));
  });
  return voices;
}

}  // namespace

// The sort of StrongestFirst takes the layers by their numbers.
static_assert(show::MotionLayer::kAdd < show::MotionLayer::kUnder &&
              show::MotionLayer::kUnder < show::MotionLayer::kOver);

void PlayMotion(State& state, const show::Show& show, std::int32_t motion, const show::MotionUse& use) {
  EndMotion(state, motion);
  for (Playing& voice : state.voices)
    if (HasSound(show, motion) && HasSound(show, voice.motion)) voice.ends = 1;
  MakeRoom(state, show);
  FreeVoice(state) = {.motion = motion,
                      .at_s = use.from_s,
                      .gain = use.from_s > 0 ? 0.0F : 1.0F,
                      .size = use.gain,
                      .number = ++state.motions_called,
                      .layer = use.layer.value_or(show.motions[static_cast<std::size_t>(motion)].layer)};
}

const Playing* Sounding(const State& state, const show::Show& show) {
  const auto sounds = [&show](const Playing& v) { return v.ends == 0 && HasSound(show, v.motion); };
  const auto voice = std::ranges::find_if(state.voices, sounds);
  return voice == state.voices.end() ? nullptr : &*voice;
}

bool IsPlaying(const State& state, std::int32_t motion) {
  return std::ranges::any_of(state.voices,
                             [=](const Playing& v) { return v.motion == motion && v.ends == 0; });
}

void EndMotion(State& state, std::int32_t motion) {
  for (Playing& voice : state.voices)
    if (voice.motion == motion) voice.ends = 1;
}

void EndMotions(State& state) {
  for (Playing& voice : state.voices) voice.ends = 1;
}

// A voice whose motion the show has not (a state of another show) plays nothing.
Motion PlayMotions(State& state, const show::Show& show, float dt_s) {
  Motion sum;
  TakesFrame takes(state, show);
  for (Playing* voice : StrongestFirst(state)) {
    if (voice->motion < 0 || voice->motion >= static_cast<int>(show.motions.size())) continue;
    const show::Motion& played = show.motions[static_cast<std::size_t>(voice->motion)];
    voice->at_s += dt_s;
    if (played.Loops()) voice->at_s = InLoop(played, voice->at_s);
    voice->gain = Travel(voice->gain, voice->ends != 0 ? 0.0F : 1.0F, dt_s, 1 / kFade_s);
    takes.Begin(*voice);
    for (const auto& curve : played.curves) {
      const float value = voice->gain * voice->size * show::ValueAt(curve.keys, played.recorded, voice->at_s);
      Add(sum, curve, value * takes.ShareOf(curve, value));
    }
    const bool ended = voice->ends != 0 && voice->gain <= 0;
    if (ended || (!played.Loops() && voice->at_s >= EndOf(played))) voice->motion = -1;
  }
  return sum;
}

}  // namespace kaori::performance
