// The show report: what an evening's log tells people.
#include "appliance/core/report/report.h"
#include "appliance/authoring/record/take.h"
#include "appliance/authoring/takes/played.h"

#include <gmock/gmock.h>

#include "tests/appliance/core/showlog_fixture.h"

namespace kaori::authoring {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::Not;
using namespace report;  // NOLINT: of evenings and their reports.

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

TEST_F(ReportTest, SaysHowLongALipsPictureTakesToTheScreen) {
  for (int frame = 0; frame < 120; ++frame) {
    board_.lips.value.quality = frame < 60 ? 0.9F : 0;  // The second half sees no mouth.
    board_.lips.at = now_ + performance::kFrame - 20ms;
    PlayQuietly();
  }
  const Evening evening = Told();
  EXPECT_NEAR(evening.lips_to_scanout.median_ms, 20, 0.1);
  EXPECT_NEAR(static_cast<double>(evening.lips_to_scanout.frames), 59, 1)
      << "nobody is measured who is not seen";
  EXPECT_THAT(TextOfReport(ReportOf(evening, {}, show_)), HasSubstr("Lips to scan-out: 20.0 ms (median)"));
}

TEST_F(ReportTest, SaysWhatALineCheckFoundAndTakesNoDeviceForLostMeanwhile) {
  EXPECT_THAT(TextOfReport(ReportOf(Evening(), {}, show_)), HasSubstr("No line check was made."));
  Run(1s);
  board_.line_check.source = board::SourceState::kLive;
  board_.line_check.value = {.phase = board::LineCheckPhase::kRunning, .count = 2};
  board_.line_check.value.items[0] = {.kind = board::CheckedKind::kAxis, .state = board::CheckedState::kSeen};
  board_.line_check.value.items[1] = {.kind = board::CheckedKind::kButton, .device = 2, .number = 6};
  board_.sticks[0].source = board_.lips.source = board::SourceState::kAbsent;  // As the stage withholds them.
  Run(5s);
  board_.line_check.value.phase = board::LineCheckPhase::kEnded;
  board_.sticks[0].source = board_.lips.source = board::SourceState::kLive;
  Run(5s);
  const Evening evening = Told();
  ASSERT_EQ(evening.line_checks.size(), 1U);
  EXPECT_EQ(evening.line_checks[0].what, "1 of 2 work; button 7 not yet seen");
  EXPECT_TRUE(evening.incidents.empty()) << evening.incidents[0].what;
  EXPECT_THAT(TextOfReport(ReportOf(evening, {}, show_)), HasSubstr(": 1 of 2 work; button 7 not yet seen."));
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

// As the packer does it.
show::Motion MotionOf(const Take& take) {
  show::Motion motion{.name = take.name, .key_usage = performance::kKey1, .curves = {}, .recorded = true};
  for (const TakeCurve& curve : take.curves)
    if (curve.target != show::MotionTarget::kChannel)
      motion.curves.push_back({curve.target, 0, PlayedKeys(take, curve)});
  return motion;
}

// The take is played by its key while the stick rests; between its in and its out it is what was recorded.
TEST_F(RecordedTake, PlaysWhatTheOperatorDid) {
  Run(2s);
  const Time from = now_ + performance::kFrame;
  const std::vector<scene::Head> heads = Move(6s);
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  const auto take = RecordTake(*log, show_, {.name = "shake", .from = from, .to = from + 6s});
  ASSERT_TRUE(take) << take.error().message();
  show_.motions = {MotionOf(*take)};
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

TEST_F(RecordedTake, HasWhatMovedAndSaysWhatIsMissing) {
  Run(2s);
  const Time from = now_;
  Move(3s);
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  const auto take = RecordTake(*log, show_, {.name = "slow", .from = from, .to = from + 2s});
  ASSERT_TRUE(take) << take.error().message();
  ASSERT_EQ(take->curves.size(), 2U) << "what does not move has no curve";
  EXPECT_EQ(take->curves[0].target, show::MotionTarget::kHeadYaw);
  EXPECT_EQ(take->curves[1].target, show::MotionTarget::kHeadPitch);
  EXPECT_NEAR(RecordedLength(*take), 2, 0.05F);
  const auto refusal = [&](const RecordOptions& options) {
    const auto refused = RecordTake(*log, show_, options);
    return refused ? "it was recorded" : refused.error().message();
  };
  EXPECT_EQ(refusal({.name = "still", .from = from - 1s, .to = from - 100ms}),
            "take \"still\": nothing moved there");
  EXPECT_EQ(refusal({.name = "late", .from = from + 1h, .to = from + 1h + 1s}),
            "take \"late\": the log has nothing there");
  EXPECT_EQ(refusal({.name = "pass", .from = from, .to = from + 2s, .with = "nod"}),
            "take \"pass\": \"nod\" did not begin there");
  EXPECT_EQ(refusal({.name = "pass", .from = from, .to = from + 2s, .with = "wave"}),
            "take \"pass\": the show has no motion or take \"wave\"");
}

TEST_F(RecordedTake, OfOneRoleHasThatOperatorsPartAlone) {
  Run(1s);
  const Time from = now_;
  for (int i = 0; i < 120; ++i) {
    board_.sticks[0].value.x = 0.5F * std::sin(0.05F * static_cast<float>(i));
    board_.sticks[1].value.x = 0.5F * std::cos(0.04F * static_cast<float>(i));
    PlayQuietly();
  }
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  const auto levels = LevelsOfRole(show_, show_.roles.roles[1].name);
  ASSERT_TRUE(levels);
  EXPECT_FALSE(LevelsOfRole(show_, "prompter"));
  const auto both = RecordTake(*log, show_, {.name = "both", .from = from, .to = from + 2s});
  const auto one = RecordTake(*log, show_, {.name = "one", .from = from, .to = from + 2s, .levels = *levels});
  ASSERT_TRUE(both && one);
  EXPECT_GT(both->curves.size(), one->curves.size());
  for (const TakeCurve& curve : one->curves)
    EXPECT_EQ(std::ranges::count_if(both->curves, [&](const TakeCurve& c) { return SameChannel(c, curve); }),
              1);
}

// A second pass: the take plays, and a hand plays to it. What is recorded is the hand's, in the time of the take.
TEST_F(RecordedTake, OfASecondPassBeginsWithTheTakeThatWasPlayedMeanwhile) {
  show_.motions[0].curves[0].keys = {{0, 0}, {2, 0.3F}, {4, 0}};
  Run(1s);
  const Time from = now_;
  board_.sticks[0].value.y = 0;
  Run(700ms);
  Strike(performance::kKey1);
  int frame = 0;
  for (const Time end = now_ + 3s; now_ < end; ++frame) {
    board_.sticks[0].value.x = frame < 60 ? 0.0F : 0.6F;  // One second after the take began.
    PlayQuietly();
  }
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  const auto take = RecordTake(*log, show_, {.name = "pass", .from = from, .to = from + 10s, .with = "nod"});
  ASSERT_TRUE(take) << take.error().message();
  ASSERT_EQ(take->curves.size(), 1U) << "the take itself is not recorded once more";
  const auto& keys = take->curves[0].keys;
  EXPECT_NEAR(RecordedAt(keys, 0.95F), 0, 0.01F);
  EXPECT_GT(std::abs(RecordedAt(keys, 1.3F)), 5) << "degrees";
}

TEST_F(RecordedTake, HasTheMouthWhereItIsAskedFor) {
  for (std::size_t i = 0; i < show_.cast.expressions.size(); ++i)
    show_.cast.expressions[i].name = fmt::format("channel {}", i);
  Run(1s);
  const Time from = now_;
  for (int i = 0; i < 120; ++i) {
    board_.surface.value.counts[4] += (i < 60 ? 1 : -1) * board_.surface.value.counts_per_turn / 60;
    PlayQuietly();
  }
  const auto log = Read();
  ASSERT_TRUE(log) << log.error().message();
  EXPECT_FALSE(RecordTake(*log, show_, {.name = "word", .from = from, .to = from + 2s}));
  const auto take = RecordTake(*log, show_, {.name = "word", .from = from, .to = from + 2s, .mouth = true});
  ASSERT_TRUE(take) << take.error().message();
  EXPECT_EQ(take->curves.size(), 4U) << "shut narrow, shut wide, open narrow, open wide";
}

}  // namespace
}  // namespace kaori::authoring
