#include "appliance/programs/lips/voice/motion_sound.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "appliance/programs/lips/voice/delay_line.h"

namespace kaori::voice {
namespace {

constexpr float kFade_per_frame = 1.0F / 480;      // 10 ms, for a beginning or a jump.
constexpr float kCutOff_per_frame = 1.0F / 12000;  // 250 ms, like the curves of a motion that is cut off.
// A sound that is farther than 20 ms from its motion jumps to it.
constexpr std::int64_t kMaxOffset_frames = 20 * kSoundRate_hz / 1000;

float Sample(std::int16_t value) {
  return static_cast<float>(value) / 32768.0F;
}

}  // namespace

// The stage writes where the motion stands at the time of each frame; where it began follows from that, and
// is told anew with each frame. A motion that was playing already when this program started is not begun in
// its middle.
void MotionSound::Follow(const board::Stamped<board::MotionNow>& now) {
  if (now.source != board::SourceState::kLive) {
    known_ = true;  // No motion was ever played, so that the first one is followed from its beginning.
    return;
  }
  const bool fresh = known_ && now.value.starts != starts_;
  if (now.value.motion != motion_ || fresh)
    CutOff(now.value.motion < 0 && now_.clip != nullptr ? kFade_per_frame : kCutOff_per_frame);
  motion_ = now.value.motion;
  starts_ = now.value.starts;
  began_ = now.at - FromSeconds(static_cast<double>(now.value.at_s));
  if (fresh)
    pending_ = motion_ >= 0 && static_cast<std::size_t>(motion_) < clips_.size() &&
               !clips_[static_cast<std::size_t>(motion_)].samples.empty();
  known_ = true;
}

// One clip fades out at a time: a third one within the fade makes the first of them end at once.
void MotionSound::CutOff(float step) {
  if (now_.clip == nullptr) return;
  before_ = now_;
  before_.gain_step = -step;
  now_ = {};
}

// Begins a clip that is due, or jumps to where its motion is when the two have come apart.
void MotionSound::Start(Time heard_at) {
  const auto position = static_cast<std::int64_t>(std::llround(Seconds(heard_at - began_) * kSoundRate_hz));
  if (position < 0) return;
  if (now_.clip != nullptr && std::abs(position - now_.position) <= kMaxOffset_frames) return;
  if (now_.clip == nullptr && !pending_) return;
  const auto* const clip = now_.clip != nullptr ? now_.clip : &clips_[static_cast<std::size_t>(motion_)];
  CutOff(kFade_per_frame);
  // A clip that begins in time begins at full volume.
  now_ = {clip, position, position == 0 ? 1.0F : 0.0F, kFade_per_frame};
  pending_ = false;
}

// Adds to what is in `frames`: the voice.
void MotionSound::Mix(std::span<float> frames, Time heard_at) {
  // A clip that begins within these frames begins at its exact frame.
  const auto silent = static_cast<std::int64_t>(std::llround(Seconds(began_ - heard_at) * kSoundRate_hz));
  const auto count = static_cast<std::int64_t>(frames.size() / 2);
  const std::int64_t first = pending_ ? std::clamp<std::int64_t>(silent, 0, count) : 0;
  if (first < count) Start(heard_at + FromSeconds(static_cast<double>(first) / kSoundRate_hz));
  for (std::int64_t n = 0; n < count; ++n) {
    float& left = frames[static_cast<std::size_t>(2 * n)];
    float& right = frames[static_cast<std::size_t>(2 * n + 1)];
    if (before_.clip != nullptr && !before_.AddFrame(left, right)) before_ = {};
    if (n >= first && now_.clip != nullptr && !now_.AddFrame(left, right)) now_ = {};
  }
}

// A clip of one channel sounds on both sides.
bool MotionSound::Playback::AddFrame(float& left, float& right) {
  const auto channels = static_cast<std::size_t>(clip->channels);
  const auto at = static_cast<std::size_t>(position++) * channels;
  if (at + channels > clip->samples.size()) return false;
  left += gain * Sample(clip->samples[at]);
  right += gain * Sample(clip->samples[at + channels - 1]);
  gain = std::clamp(gain + gain_step, 0.0F, 1.0F);
  return gain > 0;
}

}  // namespace kaori::voice
