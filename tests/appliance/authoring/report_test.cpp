// The show report: what an evening's log tells people.
#include "appliance/authoring/report/report.h"

#include <gmock/gmock.h>

#include "tests/appliance/core/showlog_fixture.h"

namespace kaori::authoring {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::Not;

class ReportTest : public showlog::ShowLogTest {
 protected:
  ReportTest() {
    show_.name = "Small <show>";
    for (const auto& [number, name, act] :
         {std::array{"1", "poster", "1"}, {"2", "narrator", ""}, {"3", "kettle", "2"}, {"4", "dog", ""}}) {
      show_.cue_list.cues.push_back(
          {.number = number, .name = name, .act = act, .scene = show::CueCall{1, 0.5F}});
    }
    show_.cue_list.cues[3].pre_wait_s = 0.5F;
    show_.cue_list.cues[2].next = show::CueNext::kContinue;
    show::Track(show_);
    state_ = performance::Opening(show_, board_, now_);
  }

  void Run(Duration time) {
    for (const Time end = now_ + time; now_ < end;) PlayQuietly();
  }
  void PlayQuietly() {
    now_ += performance::kFrame;
    const auto events = performance::ReadEvents(state_.seen, board_);
    performed_ = performance::Animate(state_, board_, events, show_, now_);
    recorder_.Note({now_, board_, state_, events}, performed_);
    state_ = performed_.state;
  }

  // Two acts; `late` is how much later than usual cue 2 comes.
  void PlayEvening(Duration late = 0s) {
    Run(1s);
    CallCueByFoot();
    Run(10s + late);
    CallCueByFoot();
    Run(100ms);
    CallCueByFoot();  // Within the guard.
    Run(5s);
    board_.sticks[0].source = board::SourceState::kStale;
    Run(3s);
    board_.sticks[0].source = board::SourceState::kLive;
    board_.sticks[0].at = now_ - 5ms;
    board_.sticks[0].value.x = 0.5F;
    Run(20s);
    CallCueByFoot();
    Run(4s);
  }

  Evening Told() {
    const auto log = Read();
    EXPECT_TRUE(log) << log.error().message();
    const showlog::LogFile* const logs[] = {&*log};
    return ReadEvening(logs, show_);
  }
};

TEST_F(ReportTest, NamesActsCuesRefusedGosAndWhatWasLost) {
  PlayEvening();
  const Evening evening = Told();
  ASSERT_EQ(evening.cues.size(), 4U);
  EXPECT_EQ(evening.frames_that_differ, 0U);
  EXPECT_STREQ(evening.cues[0].by, "foot switch");
  EXPECT_STREQ(evening.cues[3].by, "by itself");
  ASSERT_EQ(evening.acts.size(), 2U);
  EXPECT_EQ(evening.acts[0].act, "1");
  EXPECT_NEAR(Seconds(evening.acts[0].length), 10, 0.1);
  EXPECT_NEAR(Seconds(evening.acts[0].until_next), 28.1, 0.1);
  EXPECT_EQ(evening.refused.size(), 1U);
  ASSERT_EQ(evening.incidents.size(), 2U);
  EXPECT_EQ(evening.incidents[0].what, "left stick is lost");
  EXPECT_EQ(evening.incidents[1].what, "left stick is back after 3.0 s");
  ASSERT_GE(evening.hand_to_scanout.frames, 1U);
  EXPECT_LT(evening.hand_to_scanout.p99_ms, 60);
}

TEST_F(ReportTest, ComparesEachCueWithTheUsualEvening) {
  PlayEvening(12s);
  const Evening late = Told();
  std::vector<Evening> earlier;
  for (const Duration usual : {0s, 2s, 4s}) {
    Evening evening = late;
    evening.cues[1].at -= 12s - usual;
    earlier.push_back(std::move(evening));
  }
  const std::string text = TextOfReport(ReportOf(late, earlier, show_));
  EXPECT_THAT(text, HasSubstr("Usual is the median of 3 earlier evenings."));
  EXPECT_THAT(text, HasSubstr("0:22        0:12   +0:10"));
  EXPECT_THAT(text, HasSubstr("left stick is back after 3.0 s"));
  EXPECT_THAT(text, HasSubstr("The log plays again to the bit."));
  const std::string page = PageOfReport(ReportOf(late, {}, show_));
  EXPECT_THAT(page, HasSubstr("Small &lt;show&gt;"));
  EXPECT_THAT(page, HasSubstr("There is no earlier evening"));
  EXPECT_THAT(page, Not(HasSubstr("+0:10")));
}

}  // namespace
}  // namespace kaori::authoring
