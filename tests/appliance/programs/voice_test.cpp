// The voice that stands in for lost lips: its level, its gate, and its vowels, spoken by rule.
#include <gtest/gtest.h>

#include "appliance/programs/lips/voice/listener.h"
#include "tests/appliance/programs/voice_mouth.h"

namespace kaori::voice {
namespace {

using std::chrono::milliseconds;

// Other numbers than those that the guess is made with.
constexpr std::array<std::array<double, 4>, kVowelCount> kFormants_hz{{{780, 1180, 2600, 3500},
                                                                       {290, 2300, 3000, 3600},
                                                                       {340, 1250, 2300, 3400},
                                                                       {500, 1850, 2550, 3450},
                                                                       {460, 820, 2450, 3350}}};
constexpr std::array kThroats = {0.95, 1.0, 1.08, 1.15};

// What a microphone gives of it, 10 ms at a time.
void Play(Listener& listener, const std::vector<float>& sound, Time from, const auto& each) {
  std::array<std::int16_t, 480> samples{};
  for (std::size_t n = 0; n + samples.size() <= sound.size(); n += samples.size()) {
    for (std::size_t i = 0; i < samples.size(); ++i)
      samples[i] = static_cast<std::int16_t>(std::clamp(sound[n + i], -1.0F, 1.0F) * 32767);
    const Time at = from + Duration(static_cast<long>(n) * 1'000'000'000L / 48000);
    each(listener.Hear({at, false, samples}, {}));
  }
}

struct Confusion {
  int right = 0, all = 0;
};

Confusion Listen(double noise_db) {
  Confusion confusion;
  for (std::size_t vowel = 0; vowel < kVowelCount; ++vowel)
    for (double pitch_hz = 100; pitch_hz <= 300; pitch_hz += 25)
      for (const double throat : kThroats) {
        Listener listener;
        int heard = 0;
        const auto sound = tests::Speak({.formants_hz = kFormants_hz[vowel],
                                         .pitch_hz = pitch_hz,
                                         .throat = throat,
                                         .noise_db = noise_db},
                                        0.3);
        Play(listener, sound, Time{}, [&](const Voice& voice) {
          if (++heard <= 10 || !voice.vowel) return;  // The moment is full after 30 ms, the gate open.
          ++confusion.all;
          confusion.right += voice.vowel->likeliest == static_cast<Vowel>(vowel) ? 1 : 0;
        });
      }
  return confusion;
}

TEST(Voice, TellsAIUEOApartFrom100To300HzAndInFourThroats) {
  const Confusion clean = Listen(-200);
  RecordProperty("right_of_1000", clean.right * 1000 / std::max(clean.all, 1));
  EXPECT_EQ(clean.all, 5 * 9 * 4 * 20);
  EXPECT_GE(clean.right * 1000, clean.all * 980) << clean.right << " of " << clean.all;
}

TEST(Voice, TellsAIUEOApartInNoise20DbBelowTheVoice) {
  const Confusion noisy = Listen(-20);
  RecordProperty("right_of_1000", noisy.right * 1000 / std::max(noisy.all, 1));
  EXPECT_EQ(noisy.all, 5 * 9 * 4 * 20);
  EXPECT_GE(noisy.right * 1000, noisy.all * 950) << noisy.right << " of " << noisy.all;
}

TEST(Voice, OpensTheMouthWidestForAAndStretchesItForI) {
  std::array<MouthShare, kVowelCount> mouths{};
  for (std::size_t vowel = 0; vowel < kVowelCount; ++vowel) {
    Listener listener;
    Play(listener, tests::Speak({.formants_hz = kFormants_hz[vowel]}, 0.2), Time{},
         [&](const Voice& voice) { mouths[vowel] = voice.vowel ? voice.vowel->mouth : MouthShare{}; });
  }
  const auto& [a, i, u, e, o] = mouths;
  EXPECT_GT(a.height, e.height);
  EXPECT_GT(e.height, i.height);
  EXPECT_GT(o.height, u.height);
  EXPECT_GT(i.width, a.width);
  EXPECT_GT(a.width, u.width);
  EXPECT_GT(u.width, o.width);
}

TEST(Voice, SilenceSaysNothing) {
  Listener listener;
  Play(listener, std::vector<float>(48000, 0), Time{}, [](const Voice& voice) {
    EXPECT_FALSE(voice.speaking);
    EXPECT_FALSE(voice.vowel);
    EXPECT_EQ(voice.level_db, kSilent_db);
  });
  EXPECT_FALSE(GuessVowel({}));
  EXPECT_FALSE(GuessVowel(std::vector<float>(360, std::nanf(""))));
}

TEST(Voice, ALevelIsOfFullScale) {
  EXPECT_FLOAT_EQ(Level_db(std::vector<float>(100, 0.1F)), -20);
  EXPECT_EQ(Level_db({}), kSilent_db);
}

TEST(Gate, OpensAboveOneLevelAndShutsBelowAnotherAfterItsHold) {
  Gate gate({.opens_db = -40, .shuts_db = -50, .hold = milliseconds(100), .rise = {}, .fall = {}});
  Time at{};
  const auto take = [&](float level_db) {
    return gate.Accept(level_db, at += milliseconds(10), milliseconds(10));
  };
  EXPECT_FALSE(take(-45));
  EXPECT_TRUE(take(-39));
  EXPECT_TRUE(take(-45));
  for (int n = 0; n < 10; ++n) EXPECT_TRUE(take(-60));
  EXPECT_FALSE(take(-60));
  EXPECT_FALSE(take(-45));
}

TEST(Gate, AVoiceOpensItWithin30MsAndOneClickDoesNot) {
  Gate voice, click;
  Time at{};
  for (int n = 0; n < 3; ++n) voice.Accept(-15, at += milliseconds(10), milliseconds(10));
  EXPECT_TRUE(voice.open());
  EXPECT_FALSE(click.Accept(-15, Time{}, milliseconds(1)));
}

}  // namespace
}  // namespace kaori::voice
