// What sound devices do to an evening: pulled, stalled, torn, drifting, starved. The voice goes on, in time.
#include <random>

#include "tests/appliance/programs/voice_fixture.h"

namespace kaori::voice {
namespace {

using namespace std::chrono_literals;
using board::SourceState;

TEST_F(VoiceFixture, HearsSaysAndSoundsInTime) {
  Run(500ms);
  EXPECT_EQ(voice().source, SourceState::kLive);
  EXPECT_EQ(voice().value.speaking, 0U);
  EXPECT_EQ(sound().source, SourceState::kLive);
  for (int n = 0; n < 3; ++n) {
    const auto late_ms = Syllable();
    ASSERT_TRUE(late_ms);
    EXPECT_NEAR(*late_ms, 101, 3);
  }
  rig().microphone().Say(0, 1);
  Run(150ms);
  EXPECT_EQ(voice().value.speaking, 1U);
  EXPECT_NEAR(voice().value.level_db, -20, 4);
  EXPECT_GT(voice().value.height, 0.7F) << "an a is open";
  EXPECT_LT(now() - voice().at, 10ms);
  EXPECT_EQ(sound().value.xruns, 0U);
  EXPECT_NEAR(sound().value.delay_ms, 100, 1);
}

TEST_F(VoiceFixture, AMicrophoneThatIsPulledIsStaleAtOnceAndBackWithinHalfASecond) {
  for (int n = 0; n < 10; ++n) {
    Run(300ms + n * 7ms);
    ASSERT_TRUE(rig().Unplug("microphone"));
    Run(20ms);
    EXPECT_EQ(voice().source, SourceState::kStale);
    Run(300ms);
    ASSERT_TRUE(rig().Plug("microphone"));
    const Time plugged = now();
    while (voice().source != SourceState::kLive && now() - plugged < 2s) Run(1ms);
    EXPECT_LE(now() - plugged, 500ms);
  }
  Run(1s);
  EXPECT_NEAR(*Syllable(), 101, 3) << "and in time again";
}

TEST_F(VoiceFixture, AMicrophoneThatStallsIsStaleWithin200MsAndOpenedAnew) {
  Run(500ms);
  rig().microphone().Say(0, 1);
  Run(200ms);
  rig().microphone().Stall(true);
  const Time stalled = now();
  while (voice().source == SourceState::kLive && now() - stalled < 1s) Run(1ms);
  EXPECT_LE(now() - stalled, 206ms);
  Run(3s);
  rig().microphone().Stall(false);
  const Time back = now();
  while (voice().source != SourceState::kLive && now() - back < 2s) Run(1ms);
  EXPECT_LE(now() - back, 500ms);
}

TEST_F(VoiceFixture, ALoudspeakerThatIsPulledComesBackInTime) {
  Run(500ms);
  EXPECT_NEAR(*Syllable(), 101, 3);
  for (int n = 0; n < 10; ++n) {
    rig().microphone().Say(1, 1);
    Run(100ms + n * 11ms);
    ASSERT_TRUE(rig().Unplug("loudspeaker"));
    Run(50ms);
    EXPECT_EQ(sound().source, SourceState::kStale);
    EXPECT_EQ(voice().source, SourceState::kLive) << "the mouth does not need it";
    Run(400ms);
    ASSERT_TRUE(rig().Plug("loudspeaker"));
    const Time plugged = now();
    while (loud_at_ < plugged && now() - plugged < 2s) Run(1ms);
    EXPECT_LE(now() - plugged, 500ms) << "it is heard again";
  }
  rig().microphone().Say(0, 0);
  Run(1s);
  EXPECT_NEAR(*Syllable(), 101, 3);
}

TEST_F(VoiceFixture, ALoudspeakerThatStandsStillIsOpenedAnew) {
  Run(500ms);
  rig().loudspeaker().Stall(true);
  Run(3s);
  rig().loudspeaker().Stall(false);
  Run(1s);
  EXPECT_NEAR(*Syllable(), 101, 3);
}

TEST_F(VoiceFixture, BlocksThatAreLostNeitherClickNorPutTheSoundOutOfTime) {
  Run(500ms);
  rig().microphone().Say(0, 1);
  Run(500ms);
  const int usual = std::exchange(steepest_, 0);
  for (int n = 0; n < 20; ++n) {
    rig().microphone().LoseBlocks(1 + n % 4);
    Run(97ms);
  }
  EXPECT_LE(steepest_, usual * 3 / 2) << "from one frame to the next";
  rig().microphone().Say(0, 0);
  Run(1s);
  EXPECT_NEAR(*Syllable(), 101, 3);
}

TEST_F(VoiceFixture, ClocksThatDriftApartStayTogetherForMinutes) {
  rig().microphone().SetDrift(250);
  rig().loudspeaker().SetDrift(-250);
  Run(10s);
  const auto before = sound().value;
  for (int n = 0; n < 4; ++n) {
    Run(30s);
    EXPECT_NEAR(*Syllable(), 101, 4);
    EXPECT_NEAR(sound().value.delay_ms, 100, 2);
  }
  EXPECT_EQ(sound().value.xruns, before.xruns);
  EXPECT_EQ(sound().value.leaps, before.leaps) << "not once by a leap";
  EXPECT_NEAR(sound().value.drift_ppm, 500, 200);
}

TEST_F(VoiceFixture, ADeviceThatRanDryGetsMoreInHandAndTheSoundIsInTimeAgain) {
  std::mt19937 random(1993);
  Run(500ms);
  for (int n = 0; n < 100; ++n) {  // Nobody serves the devices, for moments of up to 90 ms.
    pump_at_ = now() + std::chrono::milliseconds(random() % 90);
    Run(100ms);
  }
  pump_at_ = {};
  const std::uint32_t dry = sound().value.xruns;
  Run(2s);
  EXPECT_NEAR(*Syllable(), 101, 4);
  EXPECT_EQ(sound().value.xruns, dry) << "what is past is past";
}

TEST_F(VoiceFixture, AHandSetsTheDelayWhileTheVoiceSpeaks) {
  Run(500ms);
  rig().microphone().Say(0, 1);
  Run(500ms);
  const int usual = std::exchange(steepest_, 0);
  for (const Duration delay : {150ms, 60ms, 500ms, 100ms}) {
    service_->Use({}, delay);
    Run(1s);
    EXPECT_NEAR(sound().value.delay_ms, Seconds(delay) * 1e3, 1);
    EXPECT_EQ(sound().value.automatic, 0U);
  }
  EXPECT_LE(steepest_, usual * 3 / 2) << "without a click";
}

TEST_F(VoiceFixture, TheDelayIsAsMeasuredWhereNoHandSetsIt) {
  auto status = board_.AcquireWriter<board::StageStatus>().value();
  Open(std::nullopt, {});
  const auto measure = [&](std::uint32_t lag_us, Duration time) {
    for (Duration passed{}; passed < time; passed += 100ms) {
      status.Write({.mouth_lag = std::chrono::microseconds(lag_us)}, now(), SourceState::kLive);
      Run(100ms);
    }
  };
  measure(0, 1s);
  EXPECT_NEAR(sound().value.asked_ms, 70, 1) << "before anything is measured";
  measure(100'000, 2s);
  const float first_ms = sound().value.asked_ms;
  EXPECT_NEAR(first_ms, 113, 3) << "the voice's own way to the mouth is added";
  measure(101'500, 2s);
  EXPECT_EQ(sound().value.asked_ms, first_ms) << "what trembles is no news";
  measure(200'000, 500ms);
  EXPECT_EQ(sound().value.asked_ms, first_ms) << "nor is what passes";
  measure(100'000, 1s);
  measure(900'000, 2s);
  EXPECT_EQ(sound().value.asked_ms, 500) << "and half a second is the most";
  EXPECT_EQ(sound().value.automatic, 1U);
  const auto kept = sound();
  Open(std::nullopt, {});
  Run(500ms);
  EXPECT_EQ(sound().value.asked_ms, kept.value.asked_ms) << "a program that is started again goes on with it";
}

show::Sound Tone(std::size_t frames) {
  show::Sound tone{2, {}};
  for (std::size_t n = 0; n < frames; ++n) {
    const auto loud = static_cast<std::int16_t>(8000 * std::sin(static_cast<double>(n) * 0.06));
    tone.samples.insert(tone.samples.end(), {loud, loud});
  }
  for (std::size_t n = 0; n < 2 * 4800; ++n) tone.samples[n] = 0;  // 100 ms of silence first.
  return tone;
}

TEST_F(VoiceFixture, TheSoundOfAMotionIsHeardWhenItsMotionIsSeen) {
  auto take = board_.AcquireWriter<board::MotionNow>().value();
  Open(100ms, {{}, Tone(48000)});
  Run(500ms);
  // A frame of 60 Hz in time, each telling how far the motion is at the light to come.
  const auto play = [&](std::int32_t number, std::uint32_t starts, Duration time) {
    const Time begins = now() + 20ms;
    onset_.reset();
    for (Duration at{}; at < time; at += 16'666'667ns) {
      take.Write({number, static_cast<float>(Seconds(at)), starts}, begins + at, SourceState::kLive);
      Run(16ms + (at.count() / 16'666'667 % 3 == 2 ? 0ms : 1ms));
    }
    return begins;
  };
  Time begins = play(1, 1, 500ms);
  ASSERT_TRUE(onset_);
  EXPECT_NEAR(Seconds(*onset_ - begins) * 1e3, 100, 1.5) << "the tone's first loud frame";
  begins = play(1, 2, 1200ms);
  EXPECT_NEAR(Seconds(*onset_ - begins) * 1e3, 0, 260) << "struck again: the first one fades out";
  EXPECT_NEAR(Seconds(loud_at_ - begins) * 1e3, 1000, 5) << "and the second is heard to its end";
  play(0, 3, 300ms);
  EXPECT_FALSE(onset_) << "a motion without a sound is silent";
  begins = play(1, 4, 300ms);
  take.Write({-1, 0, 4}, now(), SourceState::kLive);
  onset_.reset();
  Run(40ms);
  onset_.reset();
  Run(500ms);
  EXPECT_FALSE(onset_) << "one that ends early ends softly, and is silent";
}

TEST_F(VoiceFixture, AVoiceWithoutALoudspeakerAndALoudspeakerWithoutAVoiceWorkAlone) {
  ASSERT_TRUE(rig().Unplug("loudspeaker"));
  Open(100ms, {});
  ASSERT_TRUE(rig().Unplug("loudspeaker"));
  Run(1s);
  EXPECT_EQ(voice().source, SourceState::kLive);
  EXPECT_EQ(sound().source, SourceState::kAbsent);
  ASSERT_TRUE(rig().Unplug("microphone"));
  ASSERT_TRUE(rig().Plug("loudspeaker"));
  Run(1s);
  EXPECT_EQ(sound().source, SourceState::kLive);
  EXPECT_EQ(sound().value.xruns, 0U);
}

}  // namespace
}  // namespace kaori::voice
