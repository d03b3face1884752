// The author's input: dials, stick, keys and pointer, and what of them plays on.
#include <gmock/gmock.h>

#include "hw-sim/evening/allocations.h"
#include "tests/appliance/programs/editor_fixture.h"

namespace kaori::tests {
namespace {

using ::testing::HasSubstr;

TEST_F(EditorPlay, TabShowsTheHandlesAndHidesThemAgain) {
  EXPECT_EQ(scene_.handles.shown, 0);
  Strike(key::kTab);
  EXPECT_GT(scene_.handles.shown, 0) << "they ease in";
  EXPECT_LT(scene_.handles.shown, 0.5F);
  Run(500ms);
  EXPECT_EQ(scene_.handles.shown, 1);
  EXPECT_EQ(scene_.caption.shown, 1);
  EXPECT_EQ(scene_.handles.pulls_m.size(), show_.cast.net.points.size());
  EXPECT_GE(scene_.handles.chosen, 0);
  EXPECT_THAT(Caption(), HasSubstr("mirror on"));
  Strike(key::kTab);
  Run(500ms);
  EXPECT_EQ(scene_.handles.shown, 0);
  EXPECT_TRUE(scene_.caption.lines.empty());
}

TEST_F(EditorPlay, DialsPullTheChosenHandleScaleAndShutTheLids) {
  Strike(key::kTab);
  ChooseHandle("MC.l");
  Turn(1, 0.5F);
  Turn(2, -0.25F);
  Turn(3, 0.125F);
  EXPECT_NEAR(PullOf("MC.l").x, 0.005F, 1e-6F);
  EXPECT_NEAR(PullOf("MC.l").y, -0.0025F, 1e-6F);
  EXPECT_NEAR(PullOf("MC.r").x, -0.005F, 1e-6F);
  EXPECT_NEAR(PullOf("MC.l").z, 0.00125F, 1e-6F);
  Turn(4, 1);
  EXPECT_NEAR(PullOf("MC.l").x, 0.01F, 1e-6F);
  Turn(5, 0.4F);
  EXPECT_NEAR(work().lids[0], 0.4F, 0.01F);
  EXPECT_EQ(editor_->session().undoable(), 5U);
  EXPECT_EQ(At(state_.knobs, performance::Knob::kMouth), 0) << "the dials pull, and do not play";
  Turn(7, -0.5F);
  EXPECT_NEAR(At(state_.knobs, performance::Knob::kLight), 0.5F, 0.01F) << "the light goes on";
}

TEST_F(EditorPlay, WhatIsPulledIsSeenInTheSameFrame) {
  Strike(key::kTab);
  Run(500ms);
  ChooseHandle("MC.l");
  const std::size_t point = PointNamed(show_.cast, "MC.l");
  const auto at = show_.cast.net.surface.column[show_.cast.net.surface.row_start[point]];
  const glm::vec3 before = composer_->Compose(scene_.weights, face::Detail::kCage).cage[at];
  Turn(3, 0.5F);
  const glm::vec3 now = composer_->Compose(scene_.weights, face::Detail::kCage).cage[at];
  EXPECT_GT(glm::distance(before, now), 0.001F);
}

TEST_F(EditorPlay, TypingANamePlaysNoMotionAndNoScene) {
  Strike(key::kTab);
  Turn(3, 0.5F);
  Strike(key::kN);
  EXPECT_THAT(Caption(), HasSubstr("name: |"));
  Type("bee");
  Strike(kF1);
  Strike(key::k1);
  StrikeWithShift(key::kMinus);
  StrikeWithShift(kKey2);
  StrikeWithShift(kX);
  Strike(key::kSpace);
  EXPECT_THAT(Caption(), HasSubstr("name: bee1_2X_|"));
  Strike(key::kBackspace);
  Strike(key::kEnter);
  EXPECT_EQ(work().name, "bee1_2X");
  EXPECT_FALSE(PlaysAMotion());
  EXPECT_EQ(state_.scene, 0);
  EXPECT_EQ(state_.blink_s[0], 10) << "nor does the space bar blink";
  EXPECT_TRUE(editor_->open());
}

TEST_F(EditorPlay, ANameTypedAtFiveFramesASecondIsSavedAsItWasTyped) {
  constexpr std::uint8_t kL = 0x0F, kO = 0x12, kK = 0x0E;
  const auto frame_of = [this](std::initializer_list<std::uint8_t> keys) {
    for (const std::uint8_t usage : keys) {
      Hold(usage, true);
      Hold(usage, false);
    }
    Frame();
  };
  Strike(key::kTab);
  Turn(3, 0.5F);
  frame_of({key::kEnter, key::kM, key::kY});  // What asks for the name, and its first letters.
  frame_of({key::kMinus, kL, kO});
  frame_of({kO, kK, key::kEnter});
  editor_->Finish();
  Frame();
  EXPECT_EQ(work().name, "my_look");
  EXPECT_GE(work().slot, 0) << "and it is saved";
}

TEST_F(EditorPlay, KeysAfterTheOneThatClosesTheEditorPlayWithinTheSameFrame) {
  Strike(key::kTab);
  Hold(kB, true);  // Struck while the editor is open: no motion.
  Hold(key::kTab, true);
  Frame();
  EXPECT_FALSE(PlaysAMotion());
  EXPECT_FALSE(editor_->open());
  Hold(key::kTab, true);
  Hold(key::kTab, true);
  Hold(kB, true);
  Frame();
  EXPECT_TRUE(PlaysAMotion());
}

TEST_F(EditorPlay, KeysThatWereStruckWithTheEditorOpenArePlayedNoLater) {
  Strike(key::kTab);
  Strike(key::k1);
  Strike(kF1);
  Turn(4, 0.3F);
  board_.sticks[1].value.slider = 1;
  Push(7);
  Strike(key::kTab);
  board_.sticks[1].value.slider = 0;
  Run(1s);
  EXPECT_FALSE(PlaysAMotion());
  EXPECT_EQ(state_.scene, 0);
  EXPECT_EQ(At(state_.knobs, performance::Knob::kMouth), 0);
  Strike(key::k1);
  EXPECT_TRUE(PlaysAMotion()) << "and now they play again";
}

TEST_F(EditorPlay, KeysThatCallStylesGoOnUnlessANameIsTyped) {
  Strike(key::kTab);
  Strike(kQ);
  EXPECT_EQ(state_.styles.to, 0);
  Strike(kW);
  EXPECT_EQ(work().pulls_m, show_.cast.expressions[2].displacement)
      << "one that calls an expression takes it";
  EXPECT_EQ(state_.expressions.to, editor_->draft());
  state_.styles.to = 3;
  Strike(key::kN);
  Strike(kQ);
  Strike(kW);
  EXPECT_EQ(state_.styles.to, 3);
  EXPECT_THAT(Caption(), HasSubstr("name: qw|"));
}

TEST_F(EditorPlay, FacesAreCalledWhileTheEditorIsOpen) {
  Strike(key::kTab);
  Push(3);
  Run(2s);
  EXPECT_EQ(state_.faces.to, 3);
  EXPECT_EQ(state_.expressions.to, editor_->draft());
  Turn(3, 0.5F);
  EXPECT_GT(editor_->session().undoable(), 0U);
}

TEST_F(EditorPlay, APressChoosesTheNearestHandleThatIsSeen) {
  Strike(key::kTab);
  for (const char* point : {"MC.l", "B2.r", "CH", "N", "T.l"}) {
    Press(PositionOf(point) + glm::vec2(0.003F, 0.003F));
    Release();
    EXPECT_EQ(Chosen(), point);
  }
  Press({0.02F, 0.02F});
  Release();
  EXPECT_EQ(Chosen(), "T.l") << "a press into nowhere chooses nothing";
  EXPECT_EQ(editor_->session().undoable(), 0U) << "choosing pulls nothing";
}

TEST_F(EditorPlay, AHandleBehindTheHeadIsNotChosen) {
  board_.sticks[0].value.x = 1;
  Strike(key::kTab);
  Run(1s);
  scene_.head.yaw_rad = 1.4F;
  const auto& shape = composer_->Compose(scene_.weights, face::Detail::kCage);
  editor::HandlePicker picker(show_.cast);
  picker.Look(show_.cast, shape, scene_, 16.0F / 9);
  const std::size_t hidden = PointNamed(show_.cast, "T.l");
  ASSERT_FALSE(picker.seen(hidden)) << "the left side is turned away";
  ASSERT_TRUE(picker.seen(PointNamed(show_.cast, "T.r")));
  EXPECT_NE(picker.Nearest(picker.position(hidden)), hidden);
}

TEST_F(EditorPlay, ADragTakesTheHandleWhereThePointerGoesAndIsOneStep) {
  Strike(key::kTab);
  Run(500ms);
  for (const std::size_t face : {0U, 2U}) {
    Push(face);
    Run(2s);
    const std::size_t steps = editor_->session().undoable();
    const glm::vec2 before = PositionOf("CH");
    Press(before);
    ASSERT_EQ(Chosen(), "CH");
    for (int i = 0; i < 10; ++i) Drag({0, 0.003F});
    Release();
    const glm::vec2 moved = PositionOf("CH") - before;
    EXPECT_NEAR(moved.y, 0.03F, 0.002F) << "face " << face;
    EXPECT_NEAR(moved.x, 0, 0.002F);
    EXPECT_EQ(editor_->session().undoable(), steps + 1);
  }
}

TEST_F(EditorPlay, TheWheelPullsOutwards) {
  Strike(key::kTab);
  ChooseHandle("CH");
  board_.pointer.value.wheel += 3;
  Frame();
  EXPECT_NEAR(PullOf("CH").z, 0.0015F, 1e-6F);
}

TEST_F(EditorPlay, StickAndArrowsGoToTheNextHandleInTheirDirection) {
  Strike(key::kTab);
  ChooseHandle("N");
  Strike(key::kDown);
  EXPECT_EQ(Chosen(), "U");
  Strike(key::kUp);
  EXPECT_EQ(Chosen(), "N");
  board_.sticks[1].value.y = -0.9F;
  Frame();
  EXPECT_EQ(Chosen(), "U");
  Run(300ms);
  EXPECT_EQ(Chosen(), "U") << "one push, one needle";
  Run(1s);
  EXPECT_NE(Chosen(), "U") << "a stick that is held goes on";
  EXPECT_EQ(state_.gaze.pitch_rad, 0) << "the eyes do not follow it";
}

TEST_F(EditorPlay, TakeNothingFromTheHeapWhileTheyAreShut) {
  Strike(key::kTab);
  Turn(3, 0.5F);
  SaveAs("one");
  Strike(key::kTab);
  Run(1s);
  editor_->Finish();  // The writer's thread takes memory, too; that the work is kept was its last request.
  const std::size_t before = sim::AllocationCount();
  for (int i = 0; i < 100; ++i) {
    board_.sticks[1].value.x = 0.01F * static_cast<float>(i);
    board_.pointer.value.x = 0.01F * static_cast<float>(i);
    Push(static_cast<std::size_t>(i % 4));
  }
  EXPECT_EQ(sim::AllocationCount(), before);
}

}  // namespace
}  // namespace kaori::tests
