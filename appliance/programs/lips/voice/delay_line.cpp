#include "appliance/programs/lips/voice/delay_line.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace kaori::voice {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

// 65536 frames, 1.37 s: the longest delay, the devices' own buffers, and room for a program that was late.
constexpr std::size_t kRing = 1U << 16U;
constexpr std::size_t kFade = 480;  // A cross-fade of 10 ms.
constexpr std::size_t kEdge = 96;   // Sound fades in and out within 2 ms at a gap.
// The weight of a new time of recording: these times jitter, while clocks drift slowly.
constexpr double kStampShare = 0.02;
// A time that is farther off means lost frames; less is enough where the driver says so itself (xrun).
constexpr Duration kGap = milliseconds(20), kGapAtXrun = milliseconds(1);
// The weight of the newest error of the position, for each 5 ms of sound that is read.
constexpr double kErrorShare = 0.1;
constexpr double kCorrection_frames = kSoundRate_hz / 2.0;  // An error is corrected in about half a second,
constexpr double kMaxSpeedChange = 0.002;                   // by reading this much faster or slower at most.
constexpr double kFar_frames = kFade;                       // A larger error is corrected by a cross-fade.
constexpr Duration kDelayChange = milliseconds(2);  // A larger change of the delay takes effect at once.
// How much the needed delay shrinks for each chunk of 2.5 ms, which the change of speed can follow.
constexpr Duration kForget = microseconds(5);
constexpr Duration kTail = microseconds(2200);  // Between the last frame read and the last one written.
constexpr Duration kMaxNeeded =
    milliseconds(80);  // A microphone that is later has stalled and is not waited for.

// The length of so many frames at 48 kHz.
Duration Frames(double frames) {
  return FromSeconds(frames / kSoundRate_hz);
}

}  // namespace

DelayLine::DelayLine() : ring_(kRing) {}

// Each block says when it was recorded. Small differences from what the count of frames says are jitter and
// drift, which are followed slowly; a large one is a gap, which is filled with silence so that the time of
// every frame in the ring stays right. Several channels become their mean.
void DelayLine::Write(const ports::SoundBlock& block, const ports::SoundFormat& format) {
  const auto channels = static_cast<std::size_t>(std::max(format.channels, 1));
  const Duration off = block.at - newest_at_;
  const Duration gap = block.xrun ? kGapAtXrun : kGap;
  if (!written_ || std::abs(off.count()) > gap.count()) {
    if (written_ && off > gap) Skip(static_cast<std::int64_t>(Seconds(off) * kSoundRate_hz));
    newest_at_ = block.at;
    written_ = true;
  } else {
    MeasureNeed();
    newest_at_ += FromSeconds(Seconds(off) * kStampShare);
  }
  for (std::size_t n = 0; n + channels <= block.samples.size(); n += channels) {
    float sum = 0;
    for (std::size_t channel = 0; channel < channels; ++channel) sum += block.samples[n + channel];
    Append(sum / (32768.0F * static_cast<float>(channels)));
  }
  newest_at_ += Frames(static_cast<double>(block.samples.size() / channels));
}

// The first frames after a gap are faded in.
void DelayLine::Append(float sample) {
  if (soft_left_ > 0) sample *= static_cast<float>(kEdge - soft_left_--) / kEdge;
  ring_[static_cast<std::size_t>(newest_++) % kRing] = sample;
}

// Lost frames are silent; the sound before them fades out, and the sound after them fades in.
void DelayLine::Skip(std::int64_t frames) {
  for (std::size_t n = 1; n <= kEdge && static_cast<std::int64_t>(n) <= newest_; ++n)
    ring_[static_cast<std::size_t>(newest_ - static_cast<std::int64_t>(n)) % kRing] *=
        static_cast<float>(n - 1) / kEdge;
  frames = std::min(frames, static_cast<std::int64_t>(kRing));
  for (std::int64_t n = 0; n < frames; ++n) Append(0);
  soft_left_ = kEdge;
}

// What is needed at the least shrinks slowly, so that a delay which had to grow once comes back down when the
// devices allow it.
void DelayLine::Read(std::span<float> into, Time heard_at, Duration delay) {
  delay = std::clamp(delay, Duration{}, kLongestDelay);
  needed_ = std::max(needed_ - kForget, Duration{});
  const Duration possible = std::max(delay, needed_);
  const bool changed = std::abs((delay - asked_).count()) >= kDelayChange.count();
  asked_ = delay;
  std::ranges::fill(into, 0.0F);
  if (!written_) return;
  Steer(PositionOf(heard_at - possible), into.size(), changed || !reading_);
  reading_ = true;
  read_until_ = heard_at + Frames(static_cast<double>(into.size()));
  delay_ = heard_at - newest_at_ + Frames(static_cast<double>(newest_) - position_);
  for (float& sample : into) sample = NextFrame();
}

// Called as a block arrives: what was read before it had to do with what was there. The largest need of the
// last seconds counts.
void DelayLine::MeasureNeed() {
  const Duration now = read_until_ - newest_at_ + kTail;
  if (reading_ && now < kMaxNeeded) needed_ = std::max(needed_, now);
}

// Where in the ring's count the sound of this time lies, fractions of a frame included.
double DelayLine::PositionOf(Time time) const {
  return static_cast<double>(newest_) + Seconds(time - newest_at_) * kSoundRate_hz;
}

// A large error, or a delay that was changed on purpose, moves the position at once under a cross-fade. A
// small one changes the speed in proportion to its smoothed size: a change of 0.2 % in pitch is not heard.
void DelayLine::Steer(double wanted, std::size_t frames, bool jump) {
  const double off = wanted - position_;
  if ((jump && std::abs(off) > 1) || std::abs(off) > kFar_frames) {
    if (fade_left_ > 0) return;  // One cross-fade ends before the next begins.
    old_position_ = position_;
    fade_left_ = kFade;
    position_ = wanted;
    error_ = 0;
    ++jumps_;
    return;
  }
  error_ += std::min(1.0, kErrorShare * static_cast<double>(frames) / 240) * (off - error_);
  speed_ = 1 + std::clamp(error_ / kCorrection_frames, -kMaxSpeedChange, kMaxSpeedChange);
}

// A cubic (Catmull-Rom) through the four frames around the position; what is not held is silent, with soft
// edges. With b and c the frames around t = 0..1 and a and d those before and after: b + t/2 (c - a + t (2a -
// 5b + 4c - d + t (3(b - c) + d - a))).
float DelayLine::At(double position) const {
  const double left = static_cast<double>(newest_) - 3 - position;
  const double kept = position - static_cast<double>(newest_) + static_cast<double>(kRing) - 3;
  const double since = position - 1;
  const double edge = std::min({left, kept, since, static_cast<double>(kEdge)});
  if (!(edge > 0)) return 0;
  const auto whole = static_cast<std::int64_t>(position);
  const auto t = static_cast<float>(position - static_cast<double>(whole));
  const auto frame = [&](std::int64_t n) { return ring_[static_cast<std::size_t>(whole + n) % kRing]; };
  const float a = frame(-1), b = frame(0), c = frame(1), d = frame(2);
  const float cubic = b + 0.5F * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
  return cubic * static_cast<float>(edge / kEdge);
}

// Returns the frame at the position and advances to the next one.
float DelayLine::NextFrame() {
  float sample = At(position_);
  position_ += speed_;
  if (fade_left_ == 0) return sample;
  const float share = static_cast<float>(fade_left_--) / kFade;
  sample += share * (At(old_position_) - sample);
  old_position_ += speed_;
  return sample;
}

}  // namespace kaori::voice
