// The simulated loudspeaker: plays what it is given on a crystal of its own, and remembers what was heard
// when.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "drivers/ports/loudspeaker.h"
#include "hw-sim/devices/operator_action.h"

namespace kaori::sim {

// Time is passed in, and the sound is played in the steps in which it is asked for: whoever looks
// more often gets shorter blocks, and the same samples. 16-bit samples at 48 kHz, left and right in
// turn; a frame is one of each. One thread.
class Loudspeaker {
 public:
  // Left and right.
  static constexpr int kChannels = 2;
  // 60 ms. What is given beyond it is lost.
  static constexpr std::size_t kRoomFrames = 2880;

  // Borrows the context.
  explicit Loudspeaker(const DeviceContext& context) : context_(context) {}

  // Sound that was heard without a break.
  struct Heard {
    Time at{};                          // When its first frame was heard.
    double frame_s = 1.0 / 48000;       // From frame to frame.
    std::vector<std::int16_t> samples;  // Left, right.
  };

  // Test's side. What was heard since the last call, the oldest first, the last 4000 blocks at most: a block
  // is what was played between two looks. A break between two blocks is silence, or a stall.
  std::vector<Heard> DrainHeard();
  double level_db() const { return level_db_; }  // Of what was heard last; -100 is silence.
  void SetDrift(double ppm) { ppm_ = ppm; }      // Its crystal runs so much faster, from the next start on.
  void Stall(bool stalled);                      // It plays nothing and stands still.
  bool stalled() const { return stalled_; }

  // Appliance's side. Frames that find no room are lost, and count as played: the driver knows how
  // much there is, unless the simulator itself was late. Play begins the sound where none was
  // playing; PlayUntil moves it on to `now`.
  ports::SoundFormat format() const { return {48000, kChannels}; }
  // Gives it frames, at `now`.
  void Play(std::span<const std::int16_t> samples, Time now);
  // Plays what was given, up to `now`; nothing more where that runs out.
  void PlayUntil(Time now);
  void Silence();  // Nobody plays any more: what waits is dropped.
  std::uint64_t played_frames() const { return played_ + lost_; }  // Since the last Silence.
  Time played_at() const { return played_at_; }                    // When the last of these was over.
  std::uint32_t dry() const { return dry_; }                       // How often nothing was there to play.

 private:
  // The crystal's own rate.
  double rate_hz() const { return 48000 * (1 + ppm_ * 1e-6); }
  // How many frames the crystal would have played by `now` beyond those that were played.
  std::size_t Due(Time now) const;
  // Moves frames from the queue to what was heard.
  void Remember(std::size_t frames);

  const DeviceContext& context_;
  // Left and right in turn, so that it always holds an even number.
  std::deque<std::int16_t> waiting_;  // Given, and not yet played.
  // For DrainHeard; a block is what was played between two looks.
  std::deque<Heard> heard_;
  // Frames come out in time; false where it stalls or has run dry.
  bool playing_ = false;
  Time start_{};  // When frame `start_frame_` was heard.
  // Counted as played_, without those that were lost.
  std::uint64_t start_frame_ = 0;
  // Frames since the last Silence; those that were lost are counted apart.
  std::uint64_t played_ = 0;
  std::uint64_t lost_ = 0;
  // Of the last frame that was played.
  Time played_at_{};
  std::uint32_t dry_ = 0;
  double level_db_ = -100;
  // How much faster the crystal runs, in millionths.
  double ppm_ = 0;
  bool stalled_ = false;
};

}  // namespace kaori::sim
