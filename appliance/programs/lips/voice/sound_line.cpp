#include "appliance/programs/lips/voice/sound_line.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace kaori::voice {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr std::size_t kRing = 1U << 16U;
constexpr std::size_t kFade = 480;  // A cross-fade of 10 ms.
constexpr std::size_t kEdge = 96;   // Sound that ends or begins does so within 2 ms.
// Of a stamp's news that is believed: stamps tremble, clocks drift slowly.
constexpr double kStampShare = 0.02;
// A stamp further off than this tells of frames that are missing; less where the source says so itself.
constexpr Duration kTorn = milliseconds(20), kTornHole = milliseconds(1);
constexpr double kErrorShare = 0.1;
constexpr double kMend_frames = kSoundRate_hz / 2.0;  // An error is mended in about half a second,
constexpr double kMostBend = 0.002;                   // and never more than so much faster or slower.
constexpr double kFar_frames = kFade;                 // What is further off is reached by a cross-fade.
constexpr Duration kChange = milliseconds(2);         // Another delay is another place at once.
constexpr Duration kForget = microseconds(5);         // What can be mended meanwhile, in chunks of 2.5 ms.
constexpr Duration kTail = microseconds(2200);        // Between what is read last and what was heard last.
constexpr Duration kMostNeeded = milliseconds(80);    // A microphone that is later has stalled: none waits.

Duration Frames(double frames) {
  return FromSeconds(frames / kSoundRate_hz);
}

}  // namespace

SoundLine::SoundLine() : ring_(kRing) {}

void SoundLine::Hear(const ports::SoundBlock& block, const ports::SoundFormat& format) {
  const auto channels = static_cast<std::size_t>(std::max(format.channels, 1));
  const Duration off = block.at - newest_at_;
  const Duration torn = block.xrun ? kTornHole : kTorn;
  if (!heard_any_ || std::abs(off.count()) > torn.count()) {
    if (heard_any_ && off > torn) Skip(static_cast<std::int64_t>(Seconds(off) * kSoundRate_hz));
    newest_at_ = block.at;
    heard_any_ = true;
  } else {
    NoteNeed();
    newest_at_ += FromSeconds(Seconds(off) * kStampShare);
  }
  for (std::size_t n = 0; n + channels <= block.samples.size(); n += channels) {
    float sum = 0;
    for (std::size_t channel = 0; channel < channels; ++channel) sum += block.samples[n + channel];
    Append(sum / (32768.0F * static_cast<float>(channels)));
  }
  newest_at_ += Frames(static_cast<double>(block.samples.size() / channels));
}

void SoundLine::Append(float sample) {
  if (soft_left_ > 0) sample *= static_cast<float>(kEdge - soft_left_--) / kEdge;
  ring_[static_cast<std::size_t>(newest_++) % kRing] = sample;
}

// Frames that were lost sound like nothing; what was before them ends softly, and what follows begins so.
void SoundLine::Skip(std::int64_t frames) {
  for (std::size_t n = 1; n <= kEdge && static_cast<std::int64_t>(n) <= newest_; ++n)
    ring_[static_cast<std::size_t>(newest_ - static_cast<std::int64_t>(n)) % kRing] *=
        static_cast<float>(n - 1) / kEdge;
  frames = std::min(frames, static_cast<std::int64_t>(kRing));
  for (std::int64_t n = 0; n < frames; ++n) Append(0);
  soft_left_ = kEdge;
}

void SoundLine::Speak(std::span<float> into, Time heard_at, Duration delay) {
  delay = std::clamp(delay, Duration{}, kLongestDelay);
  needed_ = std::max(needed_ - kForget, Duration{});
  const Duration possible = std::max(delay, needed_);
  const bool changed = std::abs((delay - asked_).count()) >= kChange.count();
  asked_ = delay;
  std::ranges::fill(into, 0.0F);
  if (!heard_any_) return;
  Steer(PlaceOf(heard_at - possible), into.size(), changed || !reading_);
  reading_ = true;
  spoken_until_ = heard_at + Frames(static_cast<double>(into.size()));
  delay_ = heard_at - newest_at_ + Frames(static_cast<double>(newest_) - place_);
  for (float& sample : into) sample = Faded();
}

// Called when a block comes: what was spoken before it had to do with what was there. The most of the last
// seconds counts.
void SoundLine::NoteNeed() {
  const Duration now = spoken_until_ - newest_at_ + kTail;
  if (reading_ && now < kMostNeeded) needed_ = std::max(needed_, now);
}

double SoundLine::PlaceOf(Time time) const {
  return static_cast<double>(newest_) + Seconds(time - newest_at_) * kSoundRate_hz;
}

void SoundLine::Steer(double wanted, std::size_t frames, bool leap) {
  const double off = wanted - place_;
  if ((leap && std::abs(off) > 1) || std::abs(off) > kFar_frames) {
    if (fade_left_ > 0) return;  // One cross-fade after the other.
    old_place_ = place_;
    fade_left_ = kFade;
    place_ = wanted;
    error_ = 0;
    ++leaps_;
    return;
  }
  error_ += std::min(1.0, kErrorShare * static_cast<double>(frames) / 240) * (off - error_);
  speed_ = 1 + std::clamp(error_ / kMend_frames, -kMostBend, kMostBend);
}

// A cubic through the four frames around it; what was not heard is silent, with soft edges.
float SoundLine::At(double place) const {
  const double left = static_cast<double>(newest_) - 3 - place;
  const double kept = place - static_cast<double>(newest_) + static_cast<double>(kRing) - 3;
  const double since = place - 1;
  const double edge = std::min({left, kept, since, static_cast<double>(kEdge)});
  if (!(edge > 0)) return 0;
  const auto whole = static_cast<std::int64_t>(place);
  const auto t = static_cast<float>(place - static_cast<double>(whole));
  const auto frame = [&](std::int64_t n) { return ring_[static_cast<std::size_t>(whole + n) % kRing]; };
  const float a = frame(-1), b = frame(0), c = frame(1), d = frame(2);
  const float cubic = b + 0.5F * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
  return cubic * static_cast<float>(edge / kEdge);
}

// One frame, and on to the next.
float SoundLine::Faded() {
  float sample = At(place_);
  place_ += speed_;
  if (fade_left_ == 0) return sample;
  const float share = static_cast<float>(fade_left_--) / kFade;
  sample += share * (At(old_place_) - sample);
  old_place_ += speed_;
  return sample;
}

}  // namespace kaori::voice
