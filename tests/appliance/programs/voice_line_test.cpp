// The delay line: late by as much as is asked, on clocks that drift, and never with a click.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "appliance/programs/lips/voice/delay_line.h"

namespace kaori::voice {
namespace {

using namespace std::chrono_literals;

constexpr double kTone_hz = 200;
constexpr float kLoud = 0.5F;
// How much a tone of this kind changes from one frame to the next, at most.
const float kSteepest = kLoud * 2 * std::numbers::pi_v<float> * static_cast<float>(kTone_hz) / kSoundRate_hz;

struct Devices {
  double microphone_ppm = 0, loudspeaker_ppm = 0;  // How much faster than the box's clock.
  Duration ahead = 20ms;                           // How early the loudspeaker wants its frames.
  Duration tremble = 0ns;                          // Of stamps, to and fro.
};

// A microphone and a loudspeaker at one line, on a clock of nothing but arithmetic. The microphone hears a
// tone whose phase tells the time, or what a test says.
class DelayLineHarness {
 public:
  explicit DelayLineHarness(const Devices& devices = {}) : devices_(devices) {}

  void Run(Duration time, Duration delay) {
    for (const Time end = now_ + time; now_ < end; now_ += 1ms) {
      while (microphone_ && HeardBy() <= now_) HearBlock();
      while (SpokenUntil() < now_ + devices_.ahead) SpeakBlock(delay);
    }
  }
  void Pull() { microphone_ = false; }
  void Plug() {
    microphone_ = true;
    while (HeardBy() <= now_) ++blocks_;  // Nobody heard these.
  }
  void LoseBlocks(int count) { blocks_ += count; }
  void LoseTime() { blocks_played_ += 8; }  // The loudspeaker stood still for 40 ms.
  void Play(std::vector<float> sound) { sound_ = std::move(sound); }

  DelayLine line;
  std::vector<float> spoken;    // Since the last Forget,
  std::vector<Time> spoken_at;  // each when it is heard.
  void Forget() {
    spoken.clear();
    spoken_at.clear();
  }
  float Steepest() const {
    float steepest = 0;
    for (std::size_t n = 1; n < spoken.size(); ++n)
      steepest = std::max(steepest, std::abs(spoken[n] - spoken[n - 1]));
    return steepest;
  }
  float Loudest() const {
    return std::abs(*std::ranges::max_element(spoken, {}, [](float v) { return std::abs(v); }));
  }
  // The delay that the newest frames really have, by the phase of the tone; of 5 ms nobody knows how often.
  double PhaseDelay_ms() const {
    double in = 0, quadrature = 0;
    for (std::size_t n = spoken.size() - 4800; n < spoken.size(); ++n) {
      const double angle = 2 * std::numbers::pi * kTone_hz * Seconds(spoken_at[n] - kStart);
      in += spoken[n] * std::sin(angle);
      quadrature += spoken[n] * std::cos(angle);
    }
    const double turns = std::atan2(-quadrature, in) / (2 * std::numbers::pi);
    return 1e3 * (turns < 0 ? turns + 1 : turns) / kTone_hz;
  }

 private:
  static constexpr Time kStart = Time{} + 1000s;
  static Duration Block(double ppm) { return FromSeconds(0.005 / (1 + ppm * 1e-6)); }
  Time HeardBy() const { return kStart + (blocks_ + 1) * Block(devices_.microphone_ppm); }
  Time SpokenUntil() const { return kStart + blocks_played_ * Block(devices_.loudspeaker_ppm); }
  Duration Tremble(std::int64_t n) const { return n * 7919 % 3 * devices_.tremble - devices_.tremble; }

  float SoundAt(Time at) const {
    const double seconds = Seconds(at - kStart);
    if (sound_.empty())
      return kLoud * static_cast<float>(std::sin(2 * std::numbers::pi * kTone_hz * seconds));
    return sound_[static_cast<std::size_t>(seconds * kSoundRate_hz) % sound_.size()];
  }
  void HearBlock() {
    std::array<std::int16_t, 240> samples;
    const Time begin = kStart + blocks_ * Block(devices_.microphone_ppm);
    for (std::size_t n = 0; n < samples.size(); ++n)
      samples[n] = static_cast<std::int16_t>(
          32767 * SoundAt(begin + static_cast<std::int64_t>(n) * Block(devices_.microphone_ppm) / 240));
    line.Write({begin + Tremble(blocks_), false, samples}, {kSoundRate_hz, 1});
    ++blocks_;
  }
  void SpeakBlock(Duration delay) {
    std::array<float, 240> samples;
    line.Read(samples, SpokenUntil() + Tremble(blocks_played_), delay);
    for (std::size_t n = 0; n < samples.size(); ++n) {
      spoken.push_back(samples[n]);
      spoken_at.push_back(SpokenUntil() +
                          static_cast<std::int64_t>(n) * Block(devices_.loudspeaker_ppm) / 240);
    }
    ++blocks_played_;
  }

  Devices devices_;
  Time now_ = kStart;
  std::int64_t blocks_ = 0, blocks_played_ = 0;
  bool microphone_ = true;
  std::vector<float> sound_;
};

double Ms(Duration time) {
  return Seconds(time) * 1e3;
}

TEST(ADelayLine, IsLateByWhatIsAskedToATenthOfAMillisecond) {
  for (const Duration delay : {62ms, 61ms, 122ms, 253ms, 499ms}) {
    DelayLineHarness harness;
    harness.Run(1500ms, delay);
    EXPECT_NEAR(Ms(harness.line.delay()), Ms(delay), 0.1);
    EXPECT_NEAR(harness.PhaseDelay_ms(), std::fmod(Ms(delay), 5.0), 0.1) << Ms(delay);
    EXPECT_NEAR(harness.Loudest(), kLoud, 0.01F);
  }
}

TEST(ADelayLine, IsAsShortAsTheDevicesAllowWhenLessIsAsked) {
  DelayLineHarness harness;
  harness.Run(2s, 0ms);
  EXPECT_GT(harness.line.delay(), 25ms)
      << "frames are wanted 20 ms before they are heard, and come in blocks of 5";
  EXPECT_LT(harness.line.delay(), 36ms);
  harness.Forget();
  harness.Run(5s, 0ms);
  EXPECT_LE(harness.Steepest(), kSteepest * 1.05F);
  EXPECT_NEAR(harness.Loudest(), kLoud, 0.01F) << "and nothing is missing";
}

TEST(ADelayLine, ChangesItsDelayWithoutAClick) {
  DelayLineHarness harness;
  harness.Run(1500ms, 80ms);
  harness.Forget();
  for (const Duration delay : {85ms, 82ms, 200ms, 500ms, 40ms, 0ms, 333ms, 81ms, 80ms}) {
    harness.Run(700ms, delay);
    EXPECT_NEAR(Ms(harness.line.delay()), std::max(Ms(delay), 30.0), 5.5) << Ms(delay);
  }
  // Two tones that cross fade are as steep as both at most, and their shares move by 1 in 480 frames.
  EXPECT_LE(harness.Steepest(), kSteepest + 2 * kLoud / 480);
}

TEST(ADelayLine, FollowsClocksThatDriftWithoutAClick) {
  for (const double ppm : {-300.0, -50.0, 50.0, 300.0}) {
    DelayLineHarness harness({.microphone_ppm = ppm, .loudspeaker_ppm = -ppm, .tremble = 500us});
    harness.Run(5s, 100ms);
    const std::uint32_t jumps = harness.line.jumps();
    harness.Forget();
    harness.Run(55s, 100ms);
    EXPECT_NEAR(Ms(harness.line.delay()), 100, 1.5) << ppm;
    EXPECT_NEAR(harness.line.drift_ppm(), 2 * ppm, 150) << "what it makes up for";
    EXPECT_EQ(harness.line.jumps(), jumps) << "without any jump";
    EXPECT_LE(harness.Steepest(), kSteepest * 1.05F);
  }
}

TEST(ADelayLine, BridgesFramesThatWereLostWithSoftEdges) {
  DelayLineHarness harness;
  harness.Run(1s, 100ms);
  harness.Forget();
  harness.LoseBlocks(6);
  harness.Run(1s, 100ms);
  EXPECT_LE(harness.Steepest(), kSteepest + 1.1F * kLoud / 96);
  EXPECT_NEAR(Ms(harness.line.delay()), 100, 0.2) << "and what comes after is in time";
}

TEST(ADelayLine, FallsSilentWithoutItsMicrophoneAndSpeaksAgainInTime) {
  DelayLineHarness harness;
  harness.Run(1s, 100ms);
  harness.Forget();
  harness.Pull();
  harness.Run(3s, 100ms);
  EXPECT_LE(harness.Steepest(), kSteepest + 1.1F * kLoud / 96);
  harness.Forget();
  harness.Run(100ms, 100ms);
  EXPECT_EQ(harness.Loudest(), 0);
  harness.Plug();
  harness.Run(1s, 100ms);
  EXPECT_LE(harness.Steepest(), kSteepest + 1.1F * kLoud / 96);
  EXPECT_NEAR(harness.Loudest(), kLoud, 0.01F);
  EXPECT_NEAR(Ms(harness.line.delay()), 100, 0.2);
}

TEST(ADelayLine, FindsItsPositionAgainAfterALoudspeakerRanDry) {
  DelayLineHarness harness;
  harness.Run(1s, 100ms);
  harness.Forget();
  harness.LoseTime();
  harness.Run(500ms, 100ms);
  EXPECT_NEAR(Ms(harness.line.delay()), 100, 0.2);
  EXPECT_LE(harness.Steepest(), kSteepest + 2 * kLoud / 480);
}

TEST(ADelayLine, MixesTwoChannelsAndIsSilentBeforeItHeardAnything) {
  DelayLine line;
  std::array<float, 240> out;
  out.fill(1);
  line.Read(out, Time{} + 5s, 50ms);
  EXPECT_EQ(*std::ranges::max_element(out), 0);
  std::vector<std::int16_t> stereo(960);
  for (std::size_t n = 0; n < stereo.size(); n += 2) stereo[n] = 16384;
  for (int block = 0; block < 20; ++block)
    line.Write({Time{} + 10s + block * 10ms, false, stereo}, {48000, 2});
  line.Read(out, Time{} + 10s + 150ms, 50ms);
  for (int n = 0; n < 5; ++n) line.Read(out, Time{} + 10s + 155ms + n * 5ms, 50ms);
  EXPECT_NEAR(out[100], 0.25F, 1e-3F) << "half of one channel, and nothing of the other";
}

}  // namespace
}  // namespace kaori::voice
