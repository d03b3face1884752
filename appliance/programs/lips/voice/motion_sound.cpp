#include "appliance/programs/lips/voice/motion_sound.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "appliance/programs/lips/voice/sound_line.h"

namespace kaori::voice {
namespace {

constexpr float kTakeSoundFade = 1.0F / 480;      // A beginning or a leap: 10 ms.
constexpr float kCutOff = 1.0F / 12000;  // 250 ms, as the curves of a motion that is cut off.
constexpr std::int64_t kAstray = 20 * kSoundRate_hz / 1000;  // Further than 20 ms beside its motion it leaps.

float Sample(std::int16_t value) {
  return static_cast<float>(value) / 32768.0F;
}

}  // namespace

void MotionSound::Follow(const board::Stamped<board::MotionNow>& now) {
  if (now.source != board::SourceState::kLive) {
    known_ = true;  // None ever played: the first one begins now.
    return;
  }
  const bool fresh = known_ && now.value.starts != starts_;
  if (now.value.motion != take_ || fresh) CutOff(now.value.motion < 0 && now_.clip != nullptr ? kTakeSoundFade : kCutOff);
  take_ = now.value.motion;
  starts_ = now.value.starts;
  began_ = now.at - FromSeconds(static_cast<double>(now.value.at_s));
  if (fresh)
    pending_ = take_ >= 0 && static_cast<std::size_t>(take_) < clips_.size() &&
               !clips_[static_cast<std::size_t>(take_)].samples.empty();
  known_ = true;
}

void MotionSound::CutOff(float step) {
  if (now_.clip == nullptr) return;
  before_ = now_;
  before_.gain_step = -step;
  now_ = {};
}

void MotionSound::Start(Time heard_at) {
  const auto place = static_cast<std::int64_t>(std::llround(Seconds(heard_at - began_) * kSoundRate_hz));
  if (place < 0) return;
  if (now_.clip != nullptr && std::abs(place - now_.place) <= kAstray) return;
  if (now_.clip == nullptr && !pending_) return;
  const auto* const clip = now_.clip != nullptr ? now_.clip : &clips_[static_cast<std::size_t>(take_)];
  CutOff(kTakeSoundFade);
  // The first frame, heard in time, is heard whole.
  now_ = {clip, place, place == 0 ? 1.0F : 0.0F, kTakeSoundFade};
  pending_ = false;
}

void MotionSound::Mix(std::span<float> frames, Time heard_at) {
  // A beginning within these frames waits for its very frame.
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

// False: it is over.
bool MotionSound::Needle::AddFrame(float& left, float& right) {
  const auto channels = static_cast<std::size_t>(clip->channels);
  const auto at = static_cast<std::size_t>(place++) * channels;
  if (at + channels > clip->samples.size()) return false;
  left += gain * Sample(clip->samples[at]);
  right += gain * Sample(clip->samples[at + channels - 1]);
  gain = std::clamp(gain + gain_step, 0.0F, 1.0F);
  return gain > 0;
}

}  // namespace kaori::voice
