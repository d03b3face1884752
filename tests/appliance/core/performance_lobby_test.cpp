// The lobby: whom she wakes for, what she says, and when she sleeps.
#include <cmath>
#include <vector>

#include "tests/appliance/core/lobby_fixture.h"

namespace kaori::performance {
namespace {

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

TEST_F(LobbyTest, WithoutASensorItsCueIsACueAsAnyOther) {
  Start();
  show_.lobby = show::Lobby{.cue = 5, .greetings = {{"en", 0}}, .visitor = 1};
  OpenLobby();
  Run(1s);
  const Tracked opened = Now();
  const float lit = Light();
  Run(90s);
  EXPECT_EQ(Phase(), LobbyPhase::kOff);
  EXPECT_TRUE(SameBits(opened, Now()));
  EXPECT_FLOAT_EQ(Light(), lit) << "she does not fall asleep where nobody can wake her";
  ComeAndBeGreeted();
  EXPECT_EQ(Phase(), LobbyPhase::kGreeting) << "and the first one whom a sensor sees is greeted";
}

TEST_F(LobbyTest, ASensorThatIsStuckDoesNotKeepHerAwake) {
  show_.lobby->stuck_s = 300;
  OpenLobby();
  ComeAndBeGreeted();
  Run(290s);
  EXPECT_EQ(Phase(), LobbyPhase::kWith);
  EXPECT_FALSE(IsSensorStuck(state_.lobby, show_));
  Run(90s);
  EXPECT_TRUE(IsSensorStuck(state_.lobby, show_));
  EXPECT_EQ(Phase(), LobbyPhase::kAsleep);
  Run(600s);
  EXPECT_EQ(Phase(), LobbyPhase::kAsleep);
  SetSomeone(false);
  Run(1s);
  ComeAndBeGreeted();
  EXPECT_EQ(Phase(), LobbyPhase::kGreeting) << "it has said the contrary, and is believed again";
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

// A smile above shut lids is no sleep. The fixture's cue of the lobby smiles with expression 7.
TEST_F(LobbyTest, SheSleepsWithASunkHeadAndWithoutAnExpressionAndComesToHerselfSmoothly) {
  OpenLobby();
  const float smile = Weight(performed_.scene.weights.expressions, 7);
  const float upright = performed_.scene.head.pitch_rad;
  ASSERT_GT(smile, 0.9F);
  FallAsleep();
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.expressions, 7), 0);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.expressions, 0), 1);
  EXPECT_LT(performed_.scene.head.pitch_rad, upright - 5 * show::kDegree);
  SetSomeone(true);
  float before = performed_.scene.head.pitch_rad, largest = 0;
  for (int frame = 0; frame < 30; ++frame) {
    const float now = Step().head.pitch_rad;
    largest = std::max(largest, std::abs(now - before));
    before = now;
  }
  EXPECT_LT(largest, 2 * show::kDegree) << "a frame";
  Run(5s);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.expressions, 7), smile);
  EXPECT_NEAR(performed_.scene.head.pitch_rad, upright, 1e-4F);
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
