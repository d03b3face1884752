// Her last face, kept over the night.
#include <gtest/gtest.h>

#include "appliance/programs/stage/last_face.h"
#include "tests/appliance/core/board_file.h"
#include "tests/appliance/programs/stage_last_face_fixture.h"

namespace kaori::stage {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using performance::Knob;

TEST_F(LastFaceTest, ComesBackWithFaceExpressionSceneAndDials) {
  Strike(performance::kF1);
  Push(8);
  board_.surface.value.counts[2] += board_.surface.value.counts_per_turn / 4;
  Play(2s);
  keeper_->KeepNow();
  board_ = {};  // The night: another board, another clock.
  const auto state = RecallLastFace(place_, show_, board_, Time{} + 3s);
  ASSERT_TRUE(state) << state.error().message();
  EXPECT_EQ(state->faces.to, state_.faces.to);
  EXPECT_EQ(state->expressions.to, 3);
  EXPECT_EQ(state->scene, 1);
  EXPECT_EQ(state->knobs, state_.knobs);
  EXPECT_NEAR(At(state->knobs, Knob::kStrength), 1.25F, 0.01F);
  EXPECT_EQ(state->last, Time{} + 3s);
}

TEST_F(LastFaceTest, TheFirstFrameOfTheNextNightIsTheLastOfThisOne) {
  Push(3);
  Play(2s);
  keeper_->KeepNow();
  const scene::Scene evening = performed_.scene;
  board_ = {};
  now_ = Time{} + 2s;
  state_ = RecallLastFace(place_, show_, board_, now_).value();
  const scene::Scene& morning = Step();
  EXPECT_NEAR(Weight(morning.weights.faces, 3), Weight(evening.weights.faces, 3), 1e-4F);
  EXPECT_EQ(morning.styles, evening.styles);
  EXPECT_FLOAT_EQ(morning.light.exposure, evening.light.exposure);
  EXPECT_TRUE(performed_.lamps & (1U << 3U));
}

TEST_F(LastFaceTest, NoPushOfTheNightBeforeIsPushedAgain) {
  Push(3);
  Strike(performance::kKey1);
  Play(3s);
  keeper_->KeepNow();
  board_ = {};
  board_.surface.source = board_.keys.source = board::SourceState::kLive;
  state_ = RecallLastFace(place_, show_, board_, now_).value();
  Step();
  EXPECT_EQ(state_.faces.to, 3);
  EXPECT_EQ(state_.voices[0].motion, -1);
}

TEST_F(LastFaceTest, IsWrittenWhenAnOperatorChangedItAndNotTwiceInHalfAMinute) {
  Play(60s);
  EXPECT_EQ(looks_, 1) << "the show's first face, once";
  Push(1);
  Play(2s);
  EXPECT_EQ(looks_, 2);
  for (int button = 2; button < 5; ++button) {
    Push(button);
    Play(2s);
  }
  EXPECT_EQ(looks_, 2);
  Play(30s);
  EXPECT_EQ(looks_, 3);
  Play(100s);
  EXPECT_EQ(looks_, 3) << "nobody touched anything";
}

// A motion that ends is waited for; one that loops would keep the evening before on the disk all night.
TEST_F(LastFaceTest, IsWrittenAlthoughAMotionLoops) {
  show_.motions = {
      {.name = "sway",
       .key_usage = performance::kKey1,
       .curves = {{show::MotionTarget::kHeadRoll, 0, {{0, 0}, {0.5F, 0.1F}, {2, 0.1F}, {3, 0.1F}}}},
       .loop_from_s = 0.5F,
       .loop_to_s = 2}};
  Play(31s);
  ASSERT_EQ(looks_, 1);
  Strike(performance::kKey1);
  Push(2);
  Play(9s);
  EXPECT_EQ(looks_, 1);
  Play(6s);
  EXPECT_EQ(looks_, 2);
}

TEST_F(LastFaceTest, ALoopOfTheCueListPlaysOnAfterTheNight) {
  show_.motions[0].loop_from_s = 0.1F;
  show_.motions[0].loop_to_s = 0.7F;
  show_.cue_list.cues = {{.number = "1", .motion = 0}};
  show::Track(show_);
  CallCueByFoot();
  Play(2s);
  keeper_->KeepNow();
  board_ = {};
  const auto state = RecallLastFace(place_, show_, board_, now_);
  ASSERT_TRUE(state) << state.error().message();
  EXPECT_EQ(state->voices[0].motion, 0);
}

TEST_F(LastFaceTest, ATogglesItemIsKeptAndNoPictureIsTakenWhileAButtonIsHeld) {
  show_.buttons[30] = {show::CallKind::kExpression, 3, show::CallMode::kToggle};
  show_.buttons[31] = {show::CallKind::kFace, 2, show::CallMode::kMomentary};
  Play(31s);
  ASSERT_EQ(looks_, 1);
  Push(30);
  Push(31);
  board_.surface.value.buttons_down = 1U << 31U;
  Play(10s);
  EXPECT_EQ(looks_, 1) << "it will not be held tomorrow";
  board_.surface.value.buttons_down = 0;
  Play(2s);
  EXPECT_EQ(looks_, 2);
  state_ = RecallLastFace(place_, show_, board_, now_).value();
  EXPECT_EQ(Weight(Step().weights.expressions, 3), 1);
  EXPECT_EQ(Weight(performed_.scene.weights.faces, 2), 0);
}

TEST_F(LastFaceTest, AFaceThatLiesThereAlreadyIsNotWrittenAgain) {
  Begin(state_);
  Play(60s);
  EXPECT_EQ(looks_, 0);
}

TEST_F(LastFaceTest, NoPictureIsTakenInAFadeABlinkAMotionOrABlackout) {
  Play(1s);
  ASSERT_EQ(looks_, 1);
  Play(31s);
  Push(2);
  Play(300ms);
  EXPECT_EQ(looks_, 1) << "a fade";
  Strike(performance::kSpace);
  Play(400ms);
  EXPECT_EQ(looks_, 1) << "a blink";
  board_.lines = {.value = {.active = 2}, .at = {}, .source = board::SourceState::kLive};
  Play(3s);
  EXPECT_EQ(looks_, 1) << "a blackout";
  keeper_->KeepNow();
  EXPECT_EQ(looks_, 1) << "nor at its end";
  board_.lines.value.active = 0;
  Play(1s);
  EXPECT_EQ(looks_, 2);
}

TEST_F(LastFaceTest, AnOrderlyEndKeepsWhatIsNew) {
  Play(1s);
  Push(4);
  Play(2s);
  ASSERT_EQ(looks_, 1);
  keeper_->KeepNow();
  EXPECT_EQ(RecallLastFace(place_, show_, board_, now_)->faces.to, 4);
}

// An update that draws a black picture would keep it otherwise, and be found to look like the last face.
TEST_F(LastFaceTest, IsNotWrittenWhileTheSystemIsTried) {
  is_on_trial_ = true;
  Push(4);
  Play(90s);
  keeper_->KeepNow();
  EXPECT_EQ(looks_, 0);
  is_on_trial_ = false;
  Play(2s);
  EXPECT_EQ(looks_, 1) << "it stays, and so does its face";
  EXPECT_EQ(RecallLastFace(place_, show_, board_, now_)->faces.to, 4);
}

TEST_F(LastFaceTest, IsPutOntoABoardThatIsNewAndOnNoOther) {
  Push(3);
  Play(2s);
  keeper_->KeepNow();
  const board::BoardFile file;
  const board::Board board = file.Open();
  auto writer = board.AcquireWriter<board::Performance>().value();
  ASSERT_TRUE(ResumeLastFace(place_, show_, board, writer, now_));
  EXPECT_EQ(board.Read<board::Performance>().source, board::SourceState::kLive);
  EXPECT_FALSE(ResumeLastFace(place_, show_, board, writer, now_))
      << "a stage that was killed goes on with the board";
}

}  // namespace
}  // namespace kaori::stage
