// An evening that is played again without one of its operators.
#include "appliance/core/showlog/minus_one.h"

#include <gmock/gmock.h>

#include "tests/appliance/core/showlog_fixture.h"

namespace kaori::showlog {
namespace {

constexpr Duration kNextDay = std::chrono::hours(23);

class MinusOneTest : public ShowLogTest {
 protected:
  // An evening of four operators. What the sticks said in each frame is kept.
  void PlayEvening(int frames) {
    for (int i = 0; i < frames; ++i) {
      Play(1);
      sticks_.push_back(board_.sticks);
      times_.push_back(now_);
      sums_.push_back(OutputSum(performed_));
    }
  }

  // Plays the evening from that frame on; `play(frame, live)` is what the live operator does. The number of frames that show
  // something else than then.
  template <class LiveOperator>
  std::size_t Differing(const LogFile& log, std::size_t from, std::string_view role, LiveOperator play) {
    auto evening = MinusOne::Open(log, show_, times_[from], role);
    EXPECT_TRUE(evening) << evening.error().message();
    performance::State state = evening->Begin(times_[from] + kNextDay);
    std::size_t differ = 0;
    for (std::size_t frame = from; frame + 1 < times_.size(); ++frame) {
      board::Snapshot live;
      play(frame, live);
      EXPECT_TRUE(evening->Lay(times_[frame] + kNextDay, live)) << frame;
      const auto events = performance::ReadEvents(state.seen, live);
      const auto performed = performance::Animate(state, live, events, show_, times_[frame] + kNextDay);
      state = performed.state;
      shown_again_.push_back(performed.scene);
      differ += OutputSum(performed) == sums_[frame] ? 0 : 1;
    }
    board::Snapshot live;
    EXPECT_FALSE(evening->Lay(times_.back() + kNextDay + 1s, live)) << "the evening is over";
    return differ;
  }

  std::vector<std::array<board::Stamped<board::Stick>, 2>> sticks_;
  std::vector<Time> times_;
  std::vector<std::uint16_t> sums_;
  std::vector<scene::Scene> shown_again_;
};

TEST_F(MinusOneTest, WithOneWhoDoesWhatWasDoneIsTheSameEvening) {
  PlayEvening(60 * 40);  // Over the seam of two parts of the log.
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  const auto does_the_same = [&](std::size_t frame, board::Snapshot& live) {
    live.sticks[0] = sticks_[frame][0];
    live.sticks[0].at += kNextDay;
  };
  EXPECT_EQ(Differing(*log, 1, "head", does_the_same), 0U) << "the first frame of a log is its beginning";
  EXPECT_EQ(Differing(*log, 1000, "head", does_the_same), 0U) << "from the middle";
}

TEST_F(MinusOneTest, LeavesThatOperatorsPartOutAndNothingElse) {
  PlayEvening(60 * 20);
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  const auto holds_still = [](std::size_t, board::Snapshot& live) {
    live.sticks[0].source = board::SourceState::kLive;
  };
  EXPECT_GT(Differing(*log, 300, "head", holds_still), 800U);
  float head = 0, head_then = 0;
  for (std::size_t frame = 60; frame < shown_again_.size(); ++frame) {
    const scene::Scene &again = shown_again_[frame], &then = shown_[300 + frame];
    ASSERT_TRUE(std::ranges::equal(
        again.weights.expressions, then.weights.expressions,
        [](const face::Term& a, const face::Term& b) { return a.index == b.index && a.weight == b.weight; }));
    head = std::max(head, std::abs(again.head.yaw_rad));
    head_then = std::max(head_then, std::abs(then.head.yaw_rad));
  }
  EXPECT_LT(head, head_then / 2) << "what is left is her own life, and motions";
}

TEST_F(MinusOneTest, OfARoleOrATimeThatIsNoneIsRefusedInOneLine) {
  PlayEvening(120);
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  EXPECT_EQ(MinusOne::Open(*log, show_, times_[0], "prompter").error().message(),
            "the show has no role \"prompter\"");
  EXPECT_TRUE(MinusOne::Open(*log, show_, times_[0], "lips"));
  EXPECT_THAT(MinusOne::Open(*log, show_, times_[0] + 1h, "head").error().message(),
              ::testing::HasSubstr("the log has nothing at 20:00:00; it begins at 19:00:00"));
}

}  // namespace
}  // namespace kaori::showlog
