// How late the voice is played: by what the stage measures, and by who has the mouth.
#include "appliance/programs/lips/voice/delay_choice.h"

#include <gtest/gtest.h>

#include "appliance/core/board/mouth.h"
#include "appliance/programs/lips/voice/voice_mouth.h"

namespace kaori::voice {
namespace {

using namespace std::chrono_literals;
using board::SourceState;

// What is chosen once a measurement of 100 ms has stood for longer than it must.
Duration ChosenAt(float quality) {
  DelayChoice choice({}, {});
  board::Snapshot board;
  board.lips = {{.quality = quality}, {}, SourceState::kLive};
  for (Time now{10s}; now < Time(13s); now += 10ms) {
    board.stage_status = {{.mouth_lag = 100ms}, now, SourceState::kLive};
    choice.Choose(board, now);
  }
  return choice.chosen();
}

TEST(DelayChoice, AddsTheFilterOfLipsThatHaveTheMouth) {
  const Duration added = ChosenAt(board::kUsableMouth) - 100ms;
  EXPECT_GT(added, 0ms);
  EXPECT_LT(added, kVoiceMouthLag);
}

TEST(DelayChoice, AddsTheLagOfTheVoiceWhereLipsAreSeenTooBadlyToBeFollowed) {
  EXPECT_EQ(ChosenAt(0.2F), 100ms + kVoiceMouthLag);
}

}  // namespace
}  // namespace kaori::voice
