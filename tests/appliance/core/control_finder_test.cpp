// Which control a person moved or pushed, among others that jitter, creep or are held.
#include "appliance/core/linecheck/control_finder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "appliance/core/linecheck/button_finder.h"
#include "appliance/core/show/roles.h"

namespace kaori::linecheck {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using board::CheckedKind;
using board::SourceState;

constexpr Duration kFrame = 20ms;

class ControlFinderTest : public ::testing::Test {
 protected:
  ControlFinderTest() {
    for (auto& stick : board_.sticks) stick = {{}, now_, SourceState::kLive};
    board_.surface = {{}, now_, SourceState::kLive};
    finder_.Begin(board_, now_);
  }
  // `move` is called before each frame with the seconds since the first.
  template <class Move>
  void Run(Duration time, Move move) {
    for (Duration t{}; t < time; t += kFrame) {
      now_ += kFrame;
      move(static_cast<float>(Seconds(t)));
      finder_.Look(board_, now_);
    }
  }
  void Run(Duration time) {
    Run(time, [](float) {});
  }
  board::Stick& Left() { return board_.sticks[0].value; }
  // "" where none was found.
  std::string Found() const { return finder_.found() ? board::NameOf(*finder_.found()) : ""; }

  board::Snapshot board_;
  Time now_{100s};
  ControlFinder finder_;
};

TEST_F(ControlFinderTest, FindsAnAxisASliderAHatAndADial) {
  Run(400ms);
  Run(1s, [&](float t) { Left().twist = std::min(1.0F, 2 * t); });
  EXPECT_EQ(Found(), "left stick twist");
  Run(2s, [&](float t) { board_.sticks[1].value.slider = 0.4F * std::min(1.0F, t); });
  EXPECT_EQ(Found(), "right stick slider") << "the next one that is moved takes its place";
  Run(1s);
  Run(1s, [&](float t) { Left().hat = t < 0.3F ? 2 : -1; });
  EXPECT_EQ(Found(), "left stick hat x");
  Run(1s);
  Run(2s, [&](float t) { board_.surface.value.counts[2] = -static_cast<int>(50 * std::min(1.0F, t)); });
  EXPECT_EQ(Found(), "dial box dial 3");
  ASSERT_EQ(finder_.found()->kind, CheckedKind::kDial);
}

TEST_F(ControlFinderTest, FindsNothingInSmallMovements) {
  Run(400ms);
  Run(1s, [&](float t) { Left().x = 0.14F * std::sin(6 * t); });
  Left().x = 0;
  Run(1s, [&](float t) { Left().slider = 0.25F * std::min(1.0F, t); });
  Run(1s, [&](float t) { Left().slider = 0.25F + 0.25F * std::min(1.0F, t); });
  EXPECT_EQ(Found(), "left stick slider") << "two halves without a rest between them are one movement";
}

TEST_F(ControlFinderTest, FindsTheOneThatWentFurthestThoughAnotherWasDraggedAlong) {
  Run(400ms);
  Run(1s, [&](float t) {
    Left().x = 0.5F * std::min(1.0F, 4 * t);
    Left().y = std::min(1.0F, 3 * t);
  });
  EXPECT_EQ(Found(), "left stick y");
}

TEST_F(ControlFinderTest, SaysSoWhereTwoMovedAlike) {
  Run(400ms);
  Run(1s, [&](float t) { Left().x = Left().y = std::min(1.0F, 3 * t); });
  EXPECT_EQ(Found(), "");
  EXPECT_TRUE(finder_.ambiguous());
  Left().x = Left().y = 0;
  Run(1s);
  Run(1s, [&](float t) { Left().x = std::min(1.0F, 3 * t); });
  EXPECT_EQ(Found(), "left stick x");
  EXPECT_FALSE(finder_.ambiguous());
}

TEST_F(ControlFinderTest, TellsAControlThatDoesNotRestFromTheOneThatIsMoved) {
  const auto jitters = [&](float t) { Left().slider = 0.5F + 0.45F * std::sin(40 * t); };
  Run(3s, jitters);
  EXPECT_EQ(Found(), "") << "it never rested";
  ASSERT_TRUE(finder_.restless(now_));
  EXPECT_EQ(board::NameOf(*finder_.restless(now_)), "left stick slider");
  Run(1s, [&](float t) {
    jitters(t);
    Left().y = -std::min(1.0F, 2 * t);
  });
  EXPECT_EQ(Found(), "left stick y");
  Run(1s);
  EXPECT_FALSE(finder_.restless(now_)) << "it rests";
}

TEST_F(ControlFinderTest, PassesOverWhatCreeps) {
  Run(400ms);
  Run(20s, [&](float t) { Left().slider = t / 20; });
  EXPECT_EQ(Found(), "");
  Run(10s, [&](float t) { Left().twist = 0.02F * std::sin(9 * t); });
  EXPECT_EQ(Found(), "");
}

TEST_F(ControlFinderTest, DoesNotTakeWhatWasHeldWhenItBegan) {
  Left().x = 1;
  finder_.Begin(board_, now_);
  Run(1s, [&](float t) { Left().x = std::max(0.0F, 1 - 5 * t); });
  EXPECT_EQ(Found(), "") << "it was let go at once";
}

TEST_F(ControlFinderTest, PassesOverADeviceThatIsNotThereAndOneThatComes) {
  board_.sticks[0].source = SourceState::kStale;
  Run(1s, [&](float t) { Left().y = std::min(1.0F, 3 * t); });
  EXPECT_EQ(Found(), "");
  Left().y = 0;
  Run(100ms);
  board_.sticks[0].source = SourceState::kLive;
  Left().y = 1;
  Run(1s);
  EXPECT_EQ(Found(), "") << "where it stands is no movement";
  Run(1s, [&](float t) { Left().y = 1 - std::min(1.0F, 3 * t); });
  EXPECT_EQ(Found(), "left stick y");
}

TEST_F(ControlFinderTest, CountsDialsOverTheEndOfTheirCounts) {
  board_.surface.value.counts[0] = std::numeric_limits<std::int32_t>::max() - 10;
  finder_.Begin(board_, now_);
  Run(400ms);
  Run(1s, [&](float t) {
    const auto turned = static_cast<std::uint32_t>(100 * std::min(1.0F, t));
    board_.surface.value.counts[0] = static_cast<std::int32_t>(
        static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max() - 10) + turned);
  });
  EXPECT_EQ(Found(), "dial box dial 1");
}

class ButtonFinderTest : public ::testing::Test {
 protected:
  ButtonFinderTest() {
    board_.surface = {{}, now_, SourceState::kLive};
    finder_.Begin(board_, now_);
  }
  void Run(Duration time) {
    for (Duration t{}; t < time; t += kFrame) {
      now_ += kFrame;
      finder_.Look(board_, now_);
    }
  }
  std::string Found() const { return finder_.found() ? board::NameOf(*finder_.found()) : ""; }

  board::Snapshot board_;
  Time now_{100s};
  ButtonFinder finder_;
};

TEST_F(ButtonFinderTest, FindsTheOneThatWasPushed) {
  Run(1s);
  EXPECT_EQ(Found(), "");
  ++board_.surface.value.pushes[6];
  Run(1s);
  EXPECT_EQ(Found(), "dial box button 7");
  board_.surface.value.pushes[31] += 2;
  Run(1s);
  EXPECT_EQ(Found(), "dial box button 32") << "twice, to make sure";
}

TEST_F(ButtonFinderTest, SaysSoWhereTwoWerePushedTogether) {
  ++board_.surface.value.pushes[6];
  Run(200ms);
  ++board_.surface.value.pushes[7];
  Run(1s);
  EXPECT_EQ(Found(), "");
  EXPECT_TRUE(finder_.ambiguous());
}

TEST_F(ButtonFinderTest, PassesOverOneThatChatters) {
  for (int i = 0; i < 100; ++i) {
    ++board_.surface.value.pushes[3];
    Run(kFrame);
  }
  EXPECT_EQ(Found(), "");
  ASSERT_TRUE(finder_.restless());
  EXPECT_EQ(board::NameOf(*finder_.restless()), "dial box button 4");
  for (int i = 0; i < 50; ++i) {
    ++board_.surface.value.pushes[3];
    if (i == 10) ++board_.surface.value.pushes[9];
    Run(kFrame);
  }
  EXPECT_EQ(Found(), "dial box button 10");
}

TEST_F(ButtonFinderTest, PassesOverOneThatChattersSlowly) {
  for (int i = 0; i < 30; ++i) {
    ++board_.surface.value.pushes[3];
    Run(100ms);
    EXPECT_EQ(Found(), "") << "no person pushes five times within half a second";
  }
}

TEST_F(ButtonFinderTest, DoesNotTakeOneThatIsLetGo) {
  board_.surface.value.buttons_down = 1;
  finder_.Begin(board_, now_);
  board_.surface.value.buttons_down = 0;
  Run(1s);
  EXPECT_EQ(Found(), "");
}

}  // namespace
}  // namespace kaori::linecheck
