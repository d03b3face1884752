// When the act that plays began.
#include <gtest/gtest.h>

#include "appliance/programs/stage/act_clock.h"

namespace kaori::stage {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.

class Acts : public ::testing::Test {
 protected:
  Acts() {
    for (const char* act : {"One", "", "Two", "Two", ""}) list_.cues.push_back({.act = act});
  }
  Time Play(std::int32_t cue) { return clock_.Step(list_, cue, now_ += 10s); }

  show::CueList list_;
  Time now_ = Time{} + 100s;
  ActClock clock_{{}, list_, -1};
};

TEST_F(Acts, AnActBeginsWithTheFirstOfItsCuesThatIsPlayed) {
  EXPECT_EQ(Play(-1), Time{}) << "nothing has begun";
  const Time one = Play(0);
  EXPECT_EQ(one, now_);
  EXPECT_EQ(Play(0), one);
  EXPECT_EQ(Play(1), one) << "a cue without an act is of the act before it";
  const Time two = Play(2);
  EXPECT_EQ(two, now_);
  EXPECT_EQ(Play(3), two) << "two cues in a row may name the same act";
  EXPECT_EQ(Play(4), two);
  EXPECT_EQ(Play(1), now_) << "a jump back begins the act again";
  EXPECT_EQ(Play(-1), Time{});
}

TEST_F(Acts, AListWithoutActsBeginsWithItsFirstCue) {
  for (auto& cue : list_.cues) cue.act.clear();
  const Time began = Play(2);
  EXPECT_EQ(began, now_);
  EXPECT_EQ(Play(4), began);
}

TEST_F(Acts, AStageThatWasKilledGoesOnCounting) {
  board::Stamped<board::ShowNow> before{.value = {}, .at = now_, .source = board::SourceState::kLive};
  before.value.cue_active = 3;
  before.value.act_began = Time{} + 42s;
  EXPECT_EQ(ActClock(before, list_, 3).Step(list_, 3, now_), Time{} + 42s);
  EXPECT_EQ(ActClock(before, list_, 3).Step(list_, 4, now_), Time{} + 42s);
}

TEST_F(Acts, ABoxThatWasSwitchedOnInTheMiddleOfAnActDoesNotGuess) {
  ActClock clock({}, list_, 3);
  EXPECT_EQ(clock.Step(list_, 3, now_), Time{});
  EXPECT_EQ(clock.Step(list_, 4, now_), Time{});
  EXPECT_EQ(clock.Step(list_, 0, now_), now_) << "until the next act";
}

}  // namespace
}  // namespace kaori::stage
