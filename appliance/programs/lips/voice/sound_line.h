// The voice on its way from the microphone's clock to the loudspeaker's: delayed as asked, never with a
// click.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/ports/microphone.h"

namespace kaori::voice {

inline constexpr int kSoundRate_hz = 48000;
inline constexpr Duration kLongestDelay = std::chrono::milliseconds(500);

// Remembers the last 1.3 s. What is heard at the loudspeaker at a time was heard by the microphone one delay
// before; the two devices' clocks may drift apart, and the line is then read a little faster or slower (at
// most 0.2 %). A place that is further off than that can mend (another delay, frames that were lost, a device
// that came anew) is reached by a cross-fade of 10 ms. One thread. Allocates nothing once it is made.
class SoundLine {
 public:
  SoundLine();

  // Takes a block at 48 kHz, of one or two channels; `block.at` is believed.
  void Hear(const ports::SoundBlock& block, const ports::SoundFormat& format);

  // The next frames of the loudspeaker, one channel of -1 .. 1, the first of which is heard at `heard_at`. Up
  // to 10 ms at once. What the microphone has not heard yet, or heard too long ago, is silent. A delay that
  // is shorter than the devices allow is made as short as they do.
  void Speak(std::span<float> into, Time heard_at, Duration delay);

  // Of the frames that were spoken last.
  Duration delay() const { return delay_; }
  float drift_ppm() const { return static_cast<float>((speed_ - 1) * 1e6); }
  std::uint32_t leaps() const { return leaps_; }

 private:
  void Append(float sample);
  void Skip(std::int64_t frames);
  void NoteNeed();
  double PlaceOf(Time time) const;
  void Steer(double wanted, std::size_t frames, bool leap);
  float At(double place) const;
  float Faded();

  std::vector<float> ring_;
  std::int64_t newest_ = 0;  // How many frames were heard since the beginning,
  Time newest_at_{};         // and when the next would be, smoothed.
  bool heard_any_ = false;
  std::size_t soft_left_ = 0;  // Frames until a beginning is wholly loud.

  double place_ = 0;  // Where it is read, in frames since the beginning.
  double speed_ = 1;
  double error_ = 0;  // How far the place is behind the wanted one, smoothed.
  bool reading_ = false;
  double old_place_ = 0;       // While a cross-fade runs: where it was read before,
  std::size_t fade_left_ = 0;  // and for how many frames still.
  Duration asked_{};
  Duration needed_{};    // The shortest delay that the devices allow.
  Time spoken_until_{};  // When the last frame that was spoken is over.
  Duration delay_{};
  std::uint32_t leaps_ = 0;
};

}  // namespace kaori::voice
