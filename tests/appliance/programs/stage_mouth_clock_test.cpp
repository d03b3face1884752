// How old the mouth is that a frame shows: of the lips where they have it, else of the voice.
#include "appliance/programs/stage/mouth_clock.h"

#include <gtest/gtest.h>

#include "appliance/core/board/mouth.h"

namespace kaori::stage {
namespace {

using namespace std::chrono_literals;
using board::SourceState;

constexpr Time kStart{10s};

// One frame that shows lips of 20 ms and a voice of 30 ms, presented at once.
board::StageStatus Measured(float quality, float voice_share) {
  board::Snapshot board;
  board.lips = {{.quality = quality}, kStart - 20ms, SourceState::kLive};
  board.voice = {{}, kStart - 30ms, SourceState::kLive};
  performance::State state;
  state.mouth_voice = voice_share;
  MouthClock clock;
  clock.Present(1, board, state);
  clock.Flip({.at = kStart, .frame = 1, .period = 20ms});
  board::StageStatus status{};
  clock.Report(status);
  return status;
}

TEST(MouthClock, MeasuresLipsThatCanBeUsed) {
  EXPECT_EQ(Measured(board::kUsableMouth, 0).lips_age, 20ms);
  EXPECT_GE(Measured(board::kUsableMouth, 0).mouth_lag, 30ms) << "a picture stands for a period";
}

TEST(MouthClock, MeasuresNoLipsThatMoveNoMouth) {
  const auto status = Measured(0.2F, 1);
  EXPECT_EQ(status.lips_age, 0ms) << "they are seen, and too badly to be followed";
  EXPECT_EQ(status.voice_age, 30ms);
  EXPECT_GE(status.mouth_lag, 40ms) << "the voice has the mouth";
}

}  // namespace
}  // namespace kaori::stage
