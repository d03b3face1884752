// What the operators' monitor says of a show.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "appliance/core/board/lines.h"
#include "appliance/programs/monitor/palette.h"
#include "tests/appliance/programs/monitor_fixture.h"

namespace kaori::monitor {
namespace {

using board::LevelOwner;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::IsEmpty;

class MonitorView : public ::testing::Test {
 protected:
  std::vector<std::string> Marks() const {
    std::vector<std::string> words;
    for (const Tag& mark : evening_.Now().marks) words.push_back(mark.words);
    return words;
  }
  const Level& LevelNamed(const View& view, const std::string& name) const {
    const auto found = std::ranges::find(view.levels, name, &Level::name);
    EXPECT_NE(found, view.levels.end()) << name;
    return *found;
  }

  MonitorEvening evening_;
};

TEST_F(MonitorView, NamesTheCueThatStandsByAndTheOneThatIsActiveWithTheirNotes) {
  const View view = evening_.Now();
  EXPECT_EQ(view.standby.number + " " + view.standby.name, "3 He comes");
  EXPECT_EQ(view.standby.notes, "After her last word.");
  EXPECT_EQ(view.active.number + " " + view.active.name, "2 House lights down");
  EXPECT_EQ(view.active.notes, "On the bell.");
  EXPECT_THAT(view.comes, IsEmpty());
}

TEST_F(MonitorView, TellsTheTimeOfDayAndHowLongTheActHasPlayed) {
  EXPECT_EQ(evening_.Now().time_of_day, "19:43:10");
  EXPECT_EQ(evening_.Now().act, "ACT Prologue") << "a cue without an act is of the act before it";
  EXPECT_EQ(evening_.Now().act_time, "0:12:34");
  evening_.show_now.value.act_began = {};
  EXPECT_THAT(evening_.Now().act_time, IsEmpty())
      << "a box that was switched on in the middle does not guess";
  for (auto& cue : evening_.show.cue_list.cues) cue.act.clear();
  EXPECT_EQ(evening_.Now().act, "CUE LIST");
  evening_.show_now.value.cue_active = -1;
  EXPECT_THAT(evening_.Now().act, IsEmpty()) << "it has not begun";
}

TEST_F(MonitorView, CountsTheWaitsThatRun) {
  using Phase = performance::CueRun::Phase;
  evening_.show_now.value.cue_pending = 2;
  evening_.show_now.value.cue_left_s = 3.21F;
  evening_.state.cue_run.phase = Phase::kPreWait;
  EXPECT_EQ(evening_.Now().comes, "3 comes in 3.3 s");
  evening_.state.cue_run.phase = Phase::kFollow;
  EXPECT_EQ(evening_.Now().comes, "3 follows in 3.3 s");
  evening_.state.cue_run.phase = Phase::kPerson;
  evening_.show.cue_list.cues[2].wait.person = show::CuePerson::kVoiceQuiet;
  EXPECT_EQ(evening_.Now().comes, "3 waits for a quiet voice, 3.3 s at most");
}

TEST_F(MonitorView, SaysWhatAGoDoesNow) {
  EXPECT_EQ(evening_.Now().go, (Tag{"GO", kGreen}));
  evening_.state.go_quiet_s = 0.1F;
  EXPECT_EQ(evening_.Now().go.words, "GO guard");
  evening_.state.cue_run.since_refused_s = 0.5F;
  EXPECT_EQ(evening_.Now().go, (Tag{"GO refused", kAmber}));
  evening_.state = {};
  evening_.show_now.value.cue_standby = 3;
  EXPECT_EQ(evening_.Now().go.words, "end of list");
  evening_.show.cue_list.cues.clear();
  EXPECT_EQ(evening_.Now().go.words, "no cue list");
}

TEST_F(MonitorView, MarksWhatIsUnusual) {
  EXPECT_THAT(Marks(), IsEmpty());
  auto& now = evening_.show_now.value;
  now.cue_state = board::kCuesPaused | board::kCuesPanicking | board::kCuesBlack;
  now.locked = 1;
  now.locked_out = 3;
  now.sheet = 1;
  now.lobby = board::LobbyState::kWith;
  EXPECT_THAT(Marks(), ElementsAre("PANIC", "BLACKOUT", "PAUSED", "LOCKED, 3 refused", "SHEET 2",
                                   "LOBBY with a visitor"));
}

TEST_F(MonitorView, TheBlackoutSwitchIsMarkedAsTheCallIs) {
  evening_.lines.value.active = 1U << static_cast<unsigned>(board::Line::kBlackout);
  EXPECT_THAT(Marks(), ElementsAre("BLACKOUT"));
}

TEST_F(MonitorView, NamesWhatIsOnStageAndHowFarItsFadeIs) {
  evening_.state.expressions.progress = 0.25F;
  evening_.state.voices[0] = {.motion = 0, .at_s = 1, .gain = 1};
  const View view = evening_.Now();
  std::vector<std::string> words;
  for (const Playing& playing : view.playing) words.push_back(playing.what + " " + playing.words);
  EXPECT_THAT(words,
              ElementsAre("face poster", "expression smile", "scene stage", "drawing wire", "motion bow"));
  EXPECT_EQ(view.playing[1].share, 0.25F);
  EXPECT_NEAR(view.playing[4].share, 0.25, 0.01) << "one of four seconds";
}

TEST_F(MonitorView, AFaceThatIsKeptJoinsTheOneThatWasCalled) {
  evening_.state.kept[0] = {.call = {show::CallKind::kFace, 1}, .on = 1};
  EXPECT_EQ(evening_.Now().playing[0].words, "poster + narrator");
}

TEST_F(MonitorView, EachLevelHasTheColourOfWhoHasIt) {
  auto& levels = evening_.show_now.value.levels;
  levels[static_cast<std::size_t>(show::Level::kHeadYaw)] = {0.31F, LevelOwner::kRole, 1};
  levels[static_cast<std::size_t>(show::Level::kLight)] = {0.6F, LevelOwner::kCue, 0};
  const View view = evening_.Now();
  EXPECT_EQ(LevelNamed(view, "head yaw").owner, evening_.show.roles.roles[1].name);
  EXPECT_EQ(LevelNamed(view, "head yaw").colour, view.roles[1].colour) << "that of its role's name";
  EXPECT_NEAR(LevelNamed(view, "head yaw").share, 0.75, 0.01);
  EXPECT_NEAR(LevelNamed(view, "head yaw").rest, 0.5, 0.01);
  EXPECT_EQ(LevelNamed(view, "light").owner, "cue");
  EXPECT_NE(LevelNamed(view, "light").colour, LevelNamed(view, "head yaw").colour);
  EXPECT_THAT(LevelNamed(view, "brow").owner, IsEmpty());
}

TEST_F(MonitorView, ALevelThatNoRolePlaysIsThereOnceSomebodyHasIt) {
  const auto is_lid = Field(&Level::name, "lid left");
  EXPECT_THAT(evening_.Now().levels, Not(Contains(is_lid)));
  evening_.show_now.value.levels[static_cast<std::size_t>(show::Level::kLidLeft)] = {1, LevelOwner::kRemote,
                                                                                     0};
  EXPECT_THAT(evening_.Now().levels, Contains(is_lid));
}

TEST_F(MonitorView, ARoleSaysFromWhereItIsPlayed) {
  evening_.show_now.value.role_devices[1] = show::kDeviceCount;
  const View view = evening_.Now();
  EXPECT_EQ(view.roles[0].words, evening_.show.roles.roles[0].name + ": dial box");
  EXPECT_EQ(view.roles[1].words, evening_.show.roles.roles[1].name + ": nobody");
}

TEST_F(MonitorView, SaysHowTheCameraSeesTheMouth) {
  EXPECT_EQ(evening_.Now().lips.words, "the mouth is seen");
  EXPECT_GT(evening_.Now().open, 0.2F);
  evening_.lips.value.quality = 0.1F;
  EXPECT_EQ(evening_.Now().lips.words, "no painted mouth is seen");
  EXPECT_EQ(evening_.Now().open, 0);
  evening_.lips.source = board::SourceState::kStale;
  EXPECT_EQ(evening_.Now().lips.words, "the camera is gone");
  evening_.lips.source = board::SourceState::kAbsent;
  EXPECT_EQ(evening_.Now().lips.words, "no camera");
}

TEST_F(MonitorView, FaultsComeBeforeWhatIsMissing) {
  using status::Mark;
  EXPECT_EQ(evening_.Now().fault, (Tag{"nothing is missing", kGreen}));
  evening_.status = {{Mark::kMissing, "dial box", "It was unplugged."},
                     {Mark::kMissing, "camera", "It is not."}};
  EXPECT_EQ(evening_.Now().fault, (Tag{"missing: dial box, camera", kAmber}));
  evening_.status.push_back({Mark::kFault, "fault", "The disk is full."});
  evening_.status.push_back({Mark::kFault, "fault", "box.toml is wrong."});
  EXPECT_EQ(evening_.Now().fault, (Tag{"fault: The disk is full. And 1 more.", kRed}));
}

TEST_F(MonitorView, NumbersThatTheShowHasNotHarmNothing) {
  auto& now = evening_.show_now.value;
  now.cue_active = now.cue_pending = 2000;
  now.cue_standby = -1;
  now.role_devices.fill(77);
  now.levels[0] = {1, LevelOwner::kRole, 7};
  evening_.state.cue_run.phase = performance::CueRun::Phase::kPerson;
  evening_.state.faces.to = evening_.state.expressions.to = evening_.state.styles.to = 999;
  evening_.state.scene = 999;
  const View view = evening_.Now();
  EXPECT_THAT(view.active.number, IsEmpty());
  EXPECT_EQ(LevelNamed(view, "face").owner, "taught");
}

TEST(MonitorClock, CountsUpToAHundredHours) {
  EXPECT_EQ(ClockText(std::chrono::seconds(7)), "0:00:07");
  EXPECT_EQ(ClockText(std::chrono::seconds(-7)), "0:00:00");
  EXPECT_EQ(ClockText(std::chrono::hours(2) + std::chrono::seconds(61)), "2:01:01");
}

}  // namespace
}  // namespace kaori::monitor
