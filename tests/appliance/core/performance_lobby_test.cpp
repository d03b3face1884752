// The lobby: whom she wakes for, what she says, when she sleeps, and who has her.
#include "appliance/core/board/lines.h"
#include "appliance/core/performance/lobby.h"
#include "appliance/core/performance/motions.h"
#include "tests/appliance/core/cues_fixture.h"

namespace kaori::performance {
namespace {

constexpr std::int32_t kTuesdayEvening = (24 + 19) * 60;

// Cue "4", the sixth, is the lobby. Motions 1 to 4 are two greetings, a word for those who stay and a
// good-bye; each lasts a second.
class LobbyTest : public CuesTest {
 protected:
  LobbyTest() {
    for (const char* name : {"hello", "konnichiwa", "stay", "bye"})
      show_.motions.push_back(
          {.name = name, .curves = {{show::MotionTarget::kHeadPitch, 0, {{0, 0}, {0.5F, 0.1F}, {1, 0}}}}});
    show_.lobby = show::Lobby{.cue = 5,
                              .greetings = {{"en", 1}, {"ja", 2}},
                              .stays = {{"en", 3}},
                              .goodbyes = {{"en", 4}},
                              .visitor = 1};
    board_.lines.source = board::SourceState::kLive;
  }

  void OpenLobby() {
    GoToCue(state_, show_, 5);
    Run(1s);
  }
  void SetSomeone(bool there) {
    board_.lines.value.active = there ? 1U << static_cast<unsigned>(board::Line::kPresence) : 0U;
  }
  void ComeAndBeGreeted() {
    SetSomeone(true);
    Run(400ms);
  }
  void FallAsleep() {
    SetSomeone(false);
    Run(70s);
    ASSERT_EQ(Phase(), LobbyPhase::kAsleep);
  }
  // What the wall clock says, once.
  void Tell(std::int32_t week_minute) {
    now_ += kFrame;
    InputEvents events = ReadEvents(state_.seen, board_);
    events.week_minute = week_minute;
    performed_ = Animate(state_, board_, events, show_, now_);
    state_ = performed_.state;
  }
  // Tuesdays from 18 to 20 o'clock.
  void OpenOnTuesdays() { show_.lobby->hours = {{(24 + 18) * 60, (24 + 20) * 60}}; }

  LobbyPhase Phase() const { return state_.lobby.phase; }
  int Plays() const {
    const Playing* youngest = Youngest(state_);
    return youngest != nullptr ? youngest->motion : -1;
  }
  float Lids() const { return performed_.scene.weights.lids_shut[0]; }
  float Light() const { return performed_.scene.light.exposure; }
};

TEST_F(LobbyTest, AShowWithoutOneIsLeftAlone) {
  show_.lobby.reset();
  OpenLobby();
  SetSomeone(true);
  Run(2s);
  EXPECT_EQ(Phase(), LobbyPhase::kOff);
  EXPECT_EQ(Plays(), -1);
}

TEST_F(LobbyTest, ItBeginsWithItsCueAndEndsWithTheNext) {
  SetSomeone(true);
  Run(2s);
  EXPECT_EQ(Phase(), LobbyPhase::kOff) << "the play is on: nobody is greeted";
  SetSomeone(false);
  Run(5s);
  OpenLobby();
  EXPECT_EQ(Phase(), LobbyPhase::kWaiting);
  Strike(kGo);
  Run(1s);
  EXPECT_EQ(run().active, 6);
  EXPECT_EQ(Phase(), LobbyPhase::kOff);
}

TEST_F(LobbyTest, TheGoThatCallsItsCueDoesNotTakeHerOver) {
  GoToCue(state_, show_, 4);
  Run(1s);
  Strike(kGo);
  Run(1s);
  EXPECT_EQ(Phase(), LobbyPhase::kWaiting);
}

TEST_F(LobbyTest, ALobbyThatBeginsByItselfIsThereFromTheFirstFrame) {
  show_.lobby->by_itself = true;
  Run(100ms);
  EXPECT_EQ(Phase(), LobbyPhase::kWaiting);
  EXPECT_EQ(run().active, 5);
}

TEST_F(LobbyTest, SheWakesForAVisitorLooksAtHimAndGreets) {
  OpenLobby();
  const float lit = Light();
  FallAsleep();
  EXPECT_FLOAT_EQ(Lids(), 1);
  EXPECT_NEAR(Light(), lit * show_.lobby->sleep_light, 1e-4F);
  ComeAndBeGreeted();
  EXPECT_EQ(Phase(), LobbyPhase::kGreeting);
  EXPECT_EQ(Plays(), 1);
  EXPECT_EQ(state_.life.target, 1);
  Run(1s);
  EXPECT_FLOAT_EQ(Lids(), 0);
  EXPECT_NEAR(Light(), lit, 1e-4F);
  EXPECT_EQ(Phase(), LobbyPhase::kWith);
}

TEST_F(LobbyTest, GreetingsTakeTurns) {
  OpenLobby();
  std::vector<int> heard;
  for (int visitor = 0; visitor < 3; ++visitor) {
    ComeAndBeGreeted();
    heard.push_back(Plays());
    SetSomeone(false);
    Run(8s);
  }
  EXPECT_EQ(heard, (std::vector{1, 2, 1}));
}

TEST_F(LobbyTest, ASensorThatFlickersIsOneVisitor) {
  OpenLobby();
  for (int i = 0; i < 20; ++i) {
    SetSomeone(i % 2 == 0);
    Run(200ms);
  }
  EXPECT_EQ(Phase(), LobbyPhase::kWaiting) << "it never saw anybody for as long as counts";
  ComeAndBeGreeted();
  for (int i = 0; i < 20; ++i) {
    SetSomeone(i % 2 == 0);
    Run(1s);
  }
  EXPECT_EQ(Phase(), LobbyPhase::kWith) << "it never saw nobody for as long as counts";
  EXPECT_EQ(state_.lobby.greeting, 0);
}

TEST_F(LobbyTest, ASensorThatIsGoneSeesNobody) {
  OpenLobby();
  ComeAndBeGreeted();
  board_.lines.source = board::SourceState::kStale;
  Run(6s);
  EXPECT_EQ(Phase(), LobbyPhase::kWaiting);
}

TEST_F(LobbyTest, WhoStaysIsSpokenToNowAndThen) {
  OpenLobby();
  ComeAndBeGreeted();
  Run(20s);
  EXPECT_EQ(state_.lobby.stay, -1);
  Run(1500ms);
  EXPECT_EQ(Plays(), 3);
  EXPECT_EQ(Phase(), LobbyPhase::kWith);
}

TEST_F(LobbyTest, WhoLeavesIsBidGoodByeAndNotLookedAtAnyMore) {
  OpenLobby();
  ComeAndBeGreeted();
  Run(1s);
  SetSomeone(false);
  Run(4200ms);
  EXPECT_EQ(Phase(), LobbyPhase::kGoodbye);
  EXPECT_EQ(Plays(), 4);
  Run(1s);
  EXPECT_EQ(Phase(), LobbyPhase::kWaiting);
  EXPECT_EQ(state_.life.target, show_.cue_list.tracked[6].gaze);
}

TEST_F(LobbyTest, WhoComesDuringTheGoodByeIsGreetedWhenItIsOver) {
  OpenLobby();
  ComeAndBeGreeted();
  Run(1s);
  SetSomeone(false);
  Run(4200ms);
  SetSomeone(true);
  Run(500ms);
  EXPECT_EQ(Plays(), 4) << "she does not break off in a word";
  Run(500ms);
  EXPECT_EQ(Phase(), LobbyPhase::kGreeting);
  EXPECT_EQ(Plays(), 2);
}

TEST_F(LobbyTest, OutsideItsHoursSheSleepsWhoeverComes) {
  OpenOnTuesdays();
  OpenLobby();
  Tell(kTuesdayEvening);
  ComeAndBeGreeted();
  EXPECT_EQ(Phase(), LobbyPhase::kGreeting);
  Tell((24 + 20) * 60);
  Run(3s);
  EXPECT_EQ(Phase(), LobbyPhase::kAsleep) << "the greeting and the good-bye are over";
  Run(60s);
  EXPECT_EQ(Phase(), LobbyPhase::kAsleep);
  Tell(kTuesdayEvening);
  Step();
  EXPECT_EQ(Phase(), LobbyPhase::kGreeting) << "somebody waited before the door";
}

TEST_F(LobbyTest, AClockThatCannotBeBelievedShutsNothing) {
  OpenOnTuesdays();
  OpenLobby();
  Tell(0);
  Run(1s);
  ASSERT_EQ(Phase(), LobbyPhase::kAsleep);
  EXPECT_TRUE(KnowsHours(state_.lobby, *show_.lobby));
  Tell(kNoWeekMinute);
  EXPECT_FALSE(KnowsHours(state_.lobby, *show_.lobby));
  ComeAndBeGreeted();
  EXPECT_EQ(Phase(), LobbyPhase::kGreeting);
}

TEST_F(LobbyTest, AnyControlTakesHerOverUntilNobodyHasTouchedOneForAWhile) {
  OpenLobby();
  FallAsleep();
  Push(3);
  Run(1s);
  EXPECT_EQ(Phase(), LobbyPhase::kTakenOver);
  EXPECT_FLOAT_EQ(Lids(), 0);
  EXPECT_EQ(Face(), 3);
  SetSomeone(true);
  Run(100s);
  board_.surface.value.counts[7] += 1;
  Run(100s);
  EXPECT_EQ(Phase(), LobbyPhase::kTakenOver) << "the last touch counts, and no visitor";
  Run(25s);
  EXPECT_EQ(Face(), show_.cue_list.tracked[6].face.now);
  EXPECT_NE(Phase(), LobbyPhase::kTakenOver);
}

TEST_F(LobbyTest, AStickThatIsHeldIsTouchedAndOneAtRestIsNot) {
  OpenLobby();
  Live();
  Run(1s);
  EXPECT_EQ(Phase(), LobbyPhase::kWaiting);
  board_.sticks[0].value.x = 0.5F;
  Run(200s);
  EXPECT_EQ(Phase(), LobbyPhase::kTakenOver);
}

TEST_F(LobbyTest, TheLockKeepsWhatItRefusesFromTakingHerOver) {
  OpenLobby();
  state_.locked = 1;
  Strike(kStop);
  Run(1s);
  EXPECT_EQ(Phase(), LobbyPhase::kWaiting);
}

TEST_F(LobbyTest, PanicWakesHerAndHoldsHerInItsSceneUntilTheLobbyHasHerAgain) {
  OpenLobby();
  FallAsleep();
  Strike(kPanic);
  Run(1s);
  EXPECT_EQ(Phase(), LobbyPhase::kTakenOver);
  EXPECT_EQ(state_.scene, show_.cue_list.panic.index);
  EXPECT_FLOAT_EQ(Lids(), 0);
  EXPECT_FLOAT_EQ(state_.lobby.asleep, 0);
  Run(121s);
  EXPECT_EQ(Phase(), LobbyPhase::kWaiting);
  EXPECT_EQ(state_.scene, show_.cue_list.tracked[6].scene.now);
}

TEST_F(LobbyTest, ABlackoutIsNotLiftedByTheLobby) {
  OpenLobby();
  Strike(kBlack);
  Run(200s);
  EXPECT_EQ(Phase(), LobbyPhase::kTakenOver);
  EXPECT_FLOAT_EQ(Light(), 0);
}

TEST_F(LobbyTest, AStateOfItIsGoneOnWithOnlyWhereEveryNumberIsOne) {
  OpenLobby();
  ComeAndBeGreeted();
  ASSERT_TRUE(IsValid(state_, show_));
  State spoilt = state_;
  spoilt.lobby.greeting = 2;
  EXPECT_FALSE(IsValid(spoilt, show_));
  spoilt = state_;
  spoilt.lobby.left_s = NAN;
  EXPECT_FALSE(IsValid(spoilt, show_));
  spoilt = state_;
  spoilt.lobby.week_minute = show::kWeekMinutes;
  EXPECT_FALSE(IsValid(spoilt, show_));
}

TEST(LobbyHours, AnOpeningMayGoOnBehindMidnightAndIntoTheNextWeek) {
  const show::Lobby lobby{.hours = {{show::kWeekMinutes - 60, show::kWeekMinutes + 90}}};
  EXPECT_FALSE(show::IsOpenAt(lobby, show::kWeekMinutes - 61));
  EXPECT_TRUE(show::IsOpenAt(lobby, show::kWeekMinutes - 1));
  EXPECT_TRUE(show::IsOpenAt(lobby, 89));
  EXPECT_FALSE(show::IsOpenAt(lobby, 90));
}

}  // namespace
}  // namespace kaori::performance
