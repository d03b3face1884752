// Where the handles' work comes from, where it is kept, and how it is called.
#include <gmock/gmock.h>

#include <fstream>

#include "tests/appliance/programs/editor_fixture.h"

namespace kaori::tests {
namespace {

using EditorCalls = EditorPlay;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(EditorCalls, BeginsFromTheExpressionInPlayWithoutALeap) {
  Push(5);
  Run(2s);
  const auto before = composer_->Compose(scene_.weights, face::Detail::kCage).cage;
  const std::vector<glm::vec3> smile(before.begin(), before.end());
  Strike(key::kTab);
  EXPECT_EQ(work().pulls_m, show_.cast.expressions[1].displacement);
  for (int i = 0; i < 60; ++i) {
    Frame();
    const auto now = composer_->Compose(scene_.weights, face::Detail::kCage).cage;
    for (std::size_t v = 0; v < smile.size(); ++v) ASSERT_LT(glm::distance(now[v], smile[v]), 1e-5F) << i;
  }
  EXPECT_THAT(Caption(), HasSubstr("new, from smile   0 undo"));
}

TEST_F(EditorCalls, ACalledExpressionIsTakenIntoWorkAndUndoGivesTheOldBack) {
  Strike(key::kTab);
  Turn(3, 0.5F);
  const Work pulled = work();
  Push(6);
  EXPECT_EQ(work().pulls_m, show_.cast.expressions[2].displacement);
  EXPECT_EQ(state_.expressions.to, editor_->draft());
  Strike(key::kZ);
  EXPECT_EQ(work(), pulled);
  Strike(key::kY);
  EXPECT_EQ(work().pulls_m, show_.cast.expressions[2].displacement);
  Strike(key::k0);
  EXPECT_EQ(work().pulls_m, show_.cast.expressions[0].displacement) << "neutral";
}

TEST_F(EditorCalls, ComparesWithBeforeAsLongAsTheKeyIsHeld) {
  Push(5);
  Run(1s);
  Strike(key::kTab);
  Turn(3, 0.5F);
  const Work pulled = work();
  Hold(key::kC, true);
  Frame();
  EXPECT_EQ(show_.cast.expressions[editor_->draft()].displacement, show_.cast.expressions[1].displacement);
  EXPECT_THAT(Caption(), HasSubstr("as it was before"));
  Hold(key::kC, false);
  Frame();
  EXPECT_EQ(show_.cast.expressions[editor_->draft()].displacement, pulled.pulls_m);
}

TEST_F(EditorCalls, SavesUnderANameAndCallsItAtOnceOnEveryFace) {
  Strike(key::kTab);
  ChooseHandle("B2.l");
  Turn(2, 0.6F);
  SaveAs("wonder");
  EXPECT_TRUE(std::filesystem::exists(folder_.folder() / "01-wonder.toml"));
  EXPECT_FALSE(editor_->session().unsaved());
  EXPECT_THAT(Caption(), HasSubstr("wonder   1 undo"));
  EXPECT_THAT(Caption(), HasSubstr("1 wonder"));
  Strike(key::kTab);
  Push(4);
  Run(2s);
  ASSERT_EQ(state_.expressions.to, 0);
  for (std::size_t face = 0; face < 4; ++face) {
    Push(face);
    Push(4);
    Run(2s);
    const auto at_rest = composer_->Compose(scene_.weights, face::Detail::kCage).cage;
    const std::vector<glm::vec3> rest(at_rest.begin(), at_rest.end());
    StrikeWithShift(key::k1);
    EXPECT_EQ(state_.expressions.to, editor_->own(0));
    EXPECT_LT(state_.expressions.progress, 1) << "it fades as others do";
    EXPECT_FALSE(PlaysAMotion()) << "Shift+1 is not 1";
    Run(2s);
    const auto now = composer_->Compose(scene_.weights, face::Detail::kCage).cage;
    float most_m = 0;
    for (std::size_t v = 0; v < rest.size(); ++v) most_m = std::max(most_m, glm::distance(rest[v], now[v]));
    EXPECT_GT(most_m, 0.001F) << show_.cast.faces[face].name;
  }
}

TEST_F(EditorCalls, OwnExpressionsAreThereAtTheNextStart) {
  Strike(key::kTab);
  Turn(3, 0.5F);
  SaveAs("one");
  const Work one = work();
  Enter();
  EXPECT_FALSE(editor_->session().unsaved());
  StrikeWithShift(key::k1);
  EXPECT_EQ(state_.expressions.to, editor_->own(0));
  for (std::size_t i = 0; i < one.pulls_m.size(); ++i)
    EXPECT_LT(glm::distance(show_.cast.expressions[editor_->own(0)].displacement[i], one.pulls_m[i]), 1e-6F);
}

TEST_F(EditorCalls, UnsavedWorkIsThereAgainWhenTheEditorIsOpenedAndAfterARestart) {
  Strike(key::kTab);
  Turn(3, 0.5F);
  const Work pulled = work();
  Strike(key::kTab);
  Push(5);
  Run(1s);
  Strike(key::kTab);
  EXPECT_EQ(work(), pulled);
  EXPECT_THAT(Caption(), HasSubstr("unsaved work"));
  Strike(key::kP);
  EXPECT_EQ(work().pulls_m, show_.cast.expressions[1].displacement);
  Strike(key::kZ);
  Enter();
  EXPECT_FALSE(editor_->open()) << "an audience may be there";
  EXPECT_EQ(work(), pulled);
  EXPECT_EQ(show_.cast.expressions[editor_->draft()].displacement, pulled.pulls_m);
  Strike(key::kTab);
  Strike(key::kZ);
  EXPECT_EQ(work().pulls_m, show_.cast.expressions[0].displacement) << "and can still be undone";
}

TEST_F(EditorCalls, NamesThatAreTakenAreRefusedAndAskedForAgain) {
  Strike(key::kTab);
  Turn(3, 0.5F);
  Strike(key::kEnter);
  Type("smile");
  Strike(key::kEnter);
  EXPECT_THAT(Caption(), HasSubstr("\"smile\" is an expression of the show"));
  EXPECT_THAT(Caption(), HasSubstr("name: smile|"));
  Type("b");
  Strike(key::kEnter);
  editor_->Finish();
  Frame();
  EXPECT_TRUE(std::filesystem::exists(folder_.folder() / "01-smileb.toml"));
  StrikeWithShift(key::kEnter);
  Type("smileb");
  Strike(key::kEnter);
  EXPECT_THAT(Caption(), HasSubstr("\"smileb\" is there already"));
  Strike(key::kEscape);
  EXPECT_THAT(Caption(), Not(HasSubstr("name:")));
}

TEST_F(EditorCalls, SavesAsNewBesideTheOldOneAndDeletesOnlyWhenAskedTwice) {
  Strike(key::kTab);
  Turn(3, 0.5F);
  SaveAs("one");
  Turn(3, 0.5F);
  StrikeWithShift(key::kEnter);
  Type("two");
  Strike(key::kEnter);
  editor_->Finish();
  Frame();
  EXPECT_TRUE(std::filesystem::exists(folder_.folder() / "01-one.toml"));
  EXPECT_TRUE(std::filesystem::exists(folder_.folder() / "02-two.toml"));
  StrikeWithShift(key::k1);
  EXPECT_EQ(work().name, "one") << "while the needles are open it is taken into work";
  Strike(key::kDelete);
  editor_->Finish();
  EXPECT_TRUE(std::filesystem::exists(folder_.folder() / "01-one.toml"));
  EXPECT_THAT(Caption(), HasSubstr("press Delete again"));
  Strike(key::kDelete);
  editor_->Finish();
  EXPECT_FALSE(std::filesystem::exists(folder_.folder() / "01-one.toml"));
  EXPECT_TRUE(editor_->session().unsaved()) << "it stays in work";
  EXPECT_TRUE(std::filesystem::exists(folder_.folder() / "02-two.toml"));
}

TEST_F(EditorCalls, TheEleventhOwnExpressionFindsNoPlace) {
  Strike(key::kTab);
  for (const char* name : {"aa", "bb", "cc", "dd", "ee", "ff", "gg", "hh", "ii", "jj"}) {
    Turn(3, 0.1F);
    StrikeWithShift(key::kEnter);
    Type(name);
    Strike(key::kEnter);
  }
  editor_->Finish();
  Frame();
  EXPECT_TRUE(std::filesystem::exists(folder_.folder() / "10-jj.toml"));
  StrikeWithShift(key::kEnter);
  Type("kk");
  Strike(key::kEnter);
  EXPECT_THAT(Caption(), HasSubstr("all ten slots are in use"));
  StrikeWithShift(key::k0);
  EXPECT_EQ(work().name, "jj") << "Shift+0 is the tenth";
}

TEST_F(EditorCalls, WorkWithoutItsFolderGoesOnInMemory) {
  std::ofstream(folder_.folder() / "file") << "no folder";
  editor_.reset();
  show_ = PlayedShow();
  editor_ = ExpressionEditor::Open(folder_.folder() / "file" / "own", show_);
  composer_ = std::make_unique<face::Composer>(show_.cast);
  Frame();
  Strike(key::kTab);
  Turn(3, 0.5F);
  EXPECT_GT(editor_->session().undoable(), 0U);
  EXPECT_THAT(Caption(), HasSubstr("not on the disk"));
  SaveAs("lost");
  Strike(key::kTab);
  StrikeWithShift(key::k1);
  EXPECT_EQ(state_.expressions.to, editor_->own(0)) << "and can be called";
}

TEST_F(EditorCalls, AnEmptyPlaceIsNotCalled) {
  StrikeWithShift(key::k1);
  EXPECT_EQ(state_.expressions.to, 0);
  EXPECT_FALSE(PlaysAMotion());
}

}  // namespace
}  // namespace kaori::tests
