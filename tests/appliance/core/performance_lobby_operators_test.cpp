// The lobby and its operators: who has her, and when she goes back.
#include "tests/appliance/core/lobby_fixture.h"

namespace kaori::performance {
namespace {

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

TEST_F(LobbyTest, ALightThatAnOperatorTurnedDownComesBackWithTheLobby) {
  OpenLobby();
  const float lit = Light();
  board_.surface.value.counts[7] -= 256;
  Run(2s);
  EXPECT_NEAR(Light(), 0, 1e-6F);
  Run(121s);
  EXPECT_EQ(Phase(), LobbyPhase::kWaiting);
  EXPECT_NEAR(Light(), lit, 1e-3F);
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

}  // namespace
}  // namespace kaori::performance
