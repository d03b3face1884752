// The delay line of the voice, from the microphone's clock to the loudspeaker's, without clicks.
//
// A frame that is heard at time t was recorded at t - delay. Blocks bring their times of recording with them
// and the loudspeaker says when a frame will be heard, both on CLOCK_MONOTONIC; what lies between the two
// clocks is measured and steered, never assumed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/ports/microphone.h"

namespace kaori::voice {

// The rate of microphone, loudspeaker and clips; a device that has no such rate is not used.
inline constexpr int kSoundRate_hz = 48000;
// The longest delay that can be asked for: a picture later than that is no picture of this voice.
inline constexpr Duration kLongestDelay = std::chrono::milliseconds(500);

// Holds the last 1.3 s. What the loudspeaker plays at a time was recorded one delay before. Where the clocks
// of the two devices drift apart, the line is read a little faster or slower, by 0.2 % at most. A larger
// error (another delay, lost frames, a device that was opened again) is corrected by a cross-fade of 10 ms.
// Used by one thread; it allocates nothing after its construction.
class DelayLine {
 public:
  DelayLine();

  // Appends a block at 48 kHz with one or two channels, recorded at `block.at`. The samples are borrowed for
  // the call.
  void Write(const ports::SoundBlock& block, const ports::SoundFormat& format);

  // Reads the next frames for the loudspeaker, one channel of -1 .. 1, at most 10 ms; the first of them is
  // heard at `heard_at`. Frames that are not recorded yet, or are no longer held, are silent. A delay that is
  // shorter than the devices allow becomes the shortest possible one.
  void Read(std::span<float> into, Time heard_at, Duration delay);

  // These belong to the frames that were read last.
  Duration delay() const { return delay_; }
  // How much faster than it was recorded the sound is read now, in millionths: the difference of the two
  // devices' clocks once the line has settled.
  float drift_ppm() const { return static_cast<float>((speed_ - 1) * 1e6); }
  // How often the position was moved under a cross-fade, since the construction.
  std::uint32_t jumps() const { return jumps_; }

 private:
  // Adds a frame; Skip adds silent ones in place of lost frames.
  void Append(float sample);
  void Skip(std::int64_t frames);
  // Notes how late a read was for what had been written by then.
  void MeasureNeed();
  // The position that was recorded at this time.
  double PositionOf(Time time) const;
  // Moves the position to where it is wanted, at once or by the speed.
  void Steer(double wanted, std::size_t frames, bool jump);
  // The sound at a position between frames; silent outside of what is held.
  float At(double position) const;
  float NextFrame();

  // The newest frames, one channel of -1 .. 1; frame n of all lies at n modulo its size.
  std::vector<float> ring_;
  std::int64_t newest_ = 0;  // How many frames were written since the beginning,
  Time newest_at_{};         // and the smoothed time of the next one.
  bool written_ = false;
  std::size_t soft_left_ = 0;  // Frames until the beginning after a gap has full volume.

  double position_ = 0;  // Where the line is read, in frames since the beginning.
  // Frames that the position goes on for each frame that is played.
  double speed_ = 1;
  double error_ = 0;  // How far the position is behind the target, smoothed.
  bool reading_ = false;
  double old_position_ = 0;    // During a cross-fade: the position before it,
  std::size_t fade_left_ = 0;  // and how many frames are left of it.
  Duration asked_{};
  Duration needed_{};  // The shortest delay that the devices allow.
  Time read_until_{};  // When the last frame that was read ends.
  Duration delay_{};
  std::uint32_t jumps_ = 0;
};

}  // namespace kaori::voice
