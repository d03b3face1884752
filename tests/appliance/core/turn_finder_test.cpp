// How many counts a hand turned a dial by, once around, with pauses for another grip.
#include "appliance/core/linecheck/turn_finder.h"

#include <gtest/gtest.h>

#include <limits>

namespace kaori::linecheck {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.

class TurnFinderTest : public ::testing::Test {
 protected:
  TurnFinderTest() {
    board_.surface = {{}, now_, board::SourceState::kLive};
    finder_.Begin(board_, now_);
  }
  void Run(Duration time) {
    for (Duration t{}; t < time; t += 20ms) {
      now_ += 20ms;
      finder_.Look(board_, now_);
    }
  }
  // Count by count, over a second.
  void Turn(std::size_t dial, int counts) {
    for (int n = 0; n < 50; ++n) {
      const int step = counts * (n + 1) / 50 - counts * n / 50;
      std::int32_t& at = board_.surface.value.counts[dial];
      at = static_cast<std::int32_t>(static_cast<std::uint32_t>(at) + static_cast<std::uint32_t>(step));
      Run(20ms);
    }
  }
  std::uint32_t Found() const { return finder_.found() ? finder_.found()->counts : 0; }

  board::Snapshot board_;
  Time now_{100s};
  TurnFinder finder_;
};

TEST_F(TurnFinderTest, CountsATurnWithPausesForAnotherGripAndEitherWay) {
  for (const int counts : {200, -1024, 24}) {
    Turn(2, counts / 2);
    Run(1s);
    EXPECT_NE(Found(), std::uint32_t(std::abs(counts))) << "it is not over yet";
    Turn(2, counts - counts / 2);
    Run(2s);
    EXPECT_EQ(Found(), std::uint32_t(std::abs(counts)));
    EXPECT_EQ(board::NameOf(finder_.found()->dial), "dial box dial 3");
  }
}

TEST_F(TurnFinderTest, MeasuresAnewWithEachTurnAndForgetsATouch) {
  Turn(0, 190);
  Run(2s);
  Turn(0, 3);
  Run(2s);
  EXPECT_EQ(Found(), 190U);
  Turn(0, 201);
  Run(2s);
  EXPECT_EQ(Found(), 201U);
}

TEST_F(TurnFinderTest, TwoDialsAtOnceAreNoTurnButANeighbourThatIsTouchedIs) {
  board_.surface.value.counts[5] += 150;
  Turn(4, 200);
  Run(2s);
  EXPECT_TRUE(finder_.ambiguous());
  EXPECT_EQ(Found(), 0U);
  board_.surface.value.counts[5] += 12;
  Turn(4, 200);
  Run(2s);
  EXPECT_FALSE(finder_.ambiguous());
  EXPECT_EQ(Found(), 200U);
}

TEST_F(TurnFinderTest, CountsThatWrapAreATurnAndWhatComesWithAPlugIsNone) {
  board_.surface.value.counts[1] = std::numeric_limits<std::int32_t>::max() - 50;
  finder_.Begin(board_, now_);
  Turn(1, 256);
  Run(2s);
  EXPECT_EQ(Found(), 256U);
  board_.surface.source = board::SourceState::kStale;
  board_.surface.value.counts[1] += 500;
  Run(100ms);
  board_.surface.source = board::SourceState::kLive;
  Run(3s);
  EXPECT_EQ(Found(), 256U);
}

}  // namespace
}  // namespace kaori::linecheck
