// The show report: what an evening's log tells people.
#include "appliance/authoring/report/report.h"
#include "appliance/authoring/report/take.h"

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

class RecordedTake : public ReportTest {
 protected:
  RecordedTake() { SetKnob(performance::Knob::kLife, 0); }

  // The left stick goes its way for so long; the heads that were shown.
  std::vector<scene::Head> Move(Duration time) {
    std::vector<scene::Head> heads;
    int frame = 0;
    for (const Time end = now_ + time; now_ < end; ++frame) {
      const float t = static_cast<float>(frame) / 60;
      board_.sticks[0].value.x = 0.7F * std::sin(3 * t);
      board_.sticks[0].value.y = 0.4F * std::sin(5 * t + 1);
      board_.sticks[0].at = now_;
      PlayQuietly();
      heads.push_back(performed_.scene.head);
    }
    return heads;
  }
};

// The take is played by its key while the stick rests; between its in and its out it is what was recorded.
TEST_F(RecordedTake, PlaysWhatTheOperatorDid) {
  Run(2s);
  const Time from = now_ + performance::kFrame;
  const std::vector<scene::Head> heads = Move(6s);
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  auto motion = RecordTake(*log, show_, {.name = "shake", .from = from, .length = 6s});
  ASSERT_TRUE(motion) << motion.error().message();
  motion->key_usage = performance::kKey1;
  show_.motions = {*motion};
  board_.sticks[0].value = {};
  Run(5s);
  Strike(performance::kKey1);
  float worst = 0;
  for (std::size_t frame = 1; frame + 20 < heads.size(); ++frame) {
    PlayQuietly();  // The motion's first frame is one step into it.
    if (frame < 20) continue;
    worst = std::max(worst, std::abs(performed_.scene.head.yaw_rad - heads[frame].yaw_rad));
    worst = std::max(worst, std::abs(performed_.scene.head.pitch_rad - heads[frame].pitch_rad));
  }
  RecordProperty("take_replay_error", fmt::format("{:.2e}", worst));
  EXPECT_LE(worst, 1e-4F);
  EXPECT_GT(std::abs(heads[30].yaw_rad), 0.05F) << "it moves";
}

TEST_F(RecordedTake, IsTextThatAShowReadsAndSaysWhatIsMissing) {
  Run(2s);
  const Time from = now_;
  Move(3s);
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  const auto slow =
      RecordTake(*log, show_, {.name = "slow", .from = from, .length = 2s, .gain = 0.5F, .stretch = 2});
  ASSERT_TRUE(slow) << slow.error().message();
  EXPECT_NEAR(slow->curves[0].keys.back().at_s, 4, 0.1);
  EXPECT_EQ(slow->curves[0].keys.front().value, 0);
  EXPECT_EQ(slow->curves[0].keys.back().value, 0);
  EXPECT_THAT(TextOfTake(*slow, show_), ::testing::StartsWith("[[motion]]\nname = \"slow\"\nhead_yaw = [\n"));
  const auto still = RecordTake(*log, show_, {.name = "still", .from = from - 1s, .length = 900ms});
  ASSERT_FALSE(still);
  EXPECT_EQ(still.error().message(), "take \"still\": nothing moved there");
  const auto late = RecordTake(*log, show_, {.name = "late", .from = from + 1h, .length = 1s});
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().message(), "take \"late\": the log has nothing there");
}

}  // namespace
}  // namespace kaori::authoring
