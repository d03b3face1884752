// An evening that the stage plays again from its show log, while one operator is live.
#include "appliance/programs/stage/evening.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "appliance/core/board/caller.h"
#include "appliance/core/board/lines.h"
#include "appliance/core/board/press_log.h"
#include "appliance/programs/stage/last_face.h"
#include "appliance/programs/stage/show_log.h"
#include "appliance/programs/stage/stage.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using ::testing::HasSubstr;

class StageEvening : public PackTest {
 protected:
  StageEvening()
      : board_(board::Board::Create((folder_ / "board").string()).value()),
        surface_(board_.AcquireWriter<board::Surface>().value()) {
    show::Show show = SmallShow();
    for (std::uint16_t i = 0; i < 4; ++i) show.buttons[i] = {show::CallKind::kFace, i};
    EXPECT_TRUE(show::SavePack(show, pack_));
    auto studio = stage::Studio::Open(std::move(show));
    EXPECT_TRUE(studio) << studio.error().message();
    studio_ = std::move(*studio);
    clock_.Advance(100s);
    Touch();
  }

  std::unique_ptr<stage::Stage> OpenStage() {
    return std::make_unique<stage::Stage>(board_, stage::StageWriters::Acquire(board_).value(), *studio_,
                                          clock_);
  }
  void Touch() { surface_.Write(surface_value_, clock_.now(), board::SourceState::kLive); }
  void Push(std::size_t button) {
    board::NotePress(surface_value_, button, clock_.now());
    Touch();
  }
  void Play(stage::Stage& stage, int frames) {
    for (int frame = 0; frame < frames; ++frame) {
      clock_.Advance(16'666'667ns);
      stage.StepUnseen();
    }
  }
  // Some frames, and then the faces 1, 2 and 3, a second each; `call`, where there is a caller, with each.
  std::filesystem::path PlayEvening(board::Caller* caller = nullptr, board::Call call = {}) {
    auto log =
        stage::ShowLog::Open(folder_ / "log", {.show = stage::ShowMark(pack_).value(), .booted_at = 1h});
    EXPECT_TRUE(log) << log.error().message();
    const auto stage = OpenStage();
    stage->SetLog(&(*log)->recorder());
    Play(*stage, 10);
    for (const std::size_t face : {1U, 2U, 3U}) {
      Push(face);
      call.at = clock_.now();
      if (caller != nullptr) caller->Make(call);
      Play(*stage, 60);
    }
    stage->SetLog(nullptr);
    (*log)->Finish();
    return (*log)->file();
  }

  ManualClock clock_;
  board::Board board_;
  board::Writer<board::Surface> surface_;
  board::Surface surface_value_;
  std::filesystem::path pack_ = folder_ / "small.kaori", roles_ = folder_ / "roles.toml";
  std::unique_ptr<stage::Studio> studio_;
};

TEST_F(StageEvening, PlaysAgainUntilItIsOverAndThenAllIsLive) {
  const std::string log = PlayEvening().string();
  clock_.Advance(1h);
  const auto stage = OpenStage();
  auto evening =
      stage::OpenEvening({.log = log, .without = "head", .at = ""}, pack_, roles_, studio_->show());
  ASSERT_TRUE(evening) << evening.error().message();
  stage->PlayOver(std::move(evening->play));
  Play(*stage, 30);
  EXPECT_EQ(stage->state().faces.to, 1);
  Play(*stage, 60);
  EXPECT_EQ(stage->state().faces.to, 2);
  Play(*stage, 120);
  EXPECT_EQ(stage->state().faces.to, 3) << "and what was pressed before is not pressed once more";
  Push(1);
  Play(*stage, 2);
  EXPECT_EQ(stage->state().faces.to, 1);
}

TEST_F(StageEvening, WithoutTheDialBoxsOperatorHasTheLiveOnes) {
  const std::string log = PlayEvening().string();
  clock_.Advance(1h);
  const auto stage = OpenStage();
  auto evening =
      stage::OpenEvening({.log = log, .without = "levels", .at = ""}, pack_, roles_, studio_->show());
  ASSERT_TRUE(evening) << evening.error().message();
  stage->PlayOver(std::move(evening->play));
  Play(*stage, 90);
  EXPECT_EQ(stage->state().faces.to, 0) << "nobody has pushed a button yet";
  Push(2);
  Play(*stage, 2);
  EXPECT_EQ(stage->state().faces.to, 2);
}

TEST_F(StageEvening, IsNotTaughtSinceItsRolesAreThoseOfThen) {
  auto caller = board::Caller::Acquire(board_, board::CallWriter::kControl).value();
  const board::Call begin{.verb = board::CallVerb::kLearn,
                          .subject = static_cast<std::uint32_t>(board::LearnCall::kBegin)};
  const std::string log = PlayEvening(&caller, begin).string();
  clock_.Advance(1h);
  const auto stage = OpenStage();
  stage->LetTeach({.file = roles_, .items = {}, .below = studio_->show().roles});
  auto lines = board_.AcquireWriter<board::Lines>().value();
  lines.Write({.active = 1U << unsigned(board::Line::kService)}, clock_.now(), board::SourceState::kLive);
  auto evening =
      stage::OpenEvening({.log = log, .without = "head", .at = ""}, pack_, roles_, studio_->show());
  ASSERT_TRUE(evening) << evening.error().message();
  stage->PlayOver(std::move(evening->play));
  Play(*stage, 160);
  EXPECT_EQ(stage->state().faces.to, 3) << "the call of then is past";
  EXPECT_EQ(board_.Read<board::Learn>().value.phase, board::LearnPhase::kNever);
  Play(*stage, 120);
  caller.Make(begin);
  Play(*stage, 2);
  EXPECT_EQ(board_.Read<board::Learn>().value.phase, board::LearnPhase::kAsking) << "it is over";
}

TEST_F(StageEvening, ThatIsNoneOfThisShowIsRefusedInOneLine) {
  const std::string log = PlayEvening().string();
  const auto refusal = [&](const std::string& without, const std::string& at) {
    return stage::OpenEvening({.log = log, .without = without, .at = at}, pack_, roles_, studio_->show())
        .error()
        .message();
  };
  EXPECT_THAT(refusal("prompter", ""), HasSubstr("the show has no role \"prompter\""));
  EXPECT_THAT(refusal("head", "soon"), HasSubstr("--at soon: a time of day is expected"));
  std::ofstream(roles_) << "handover_s = 0.5\n";
  EXPECT_THAT(refusal("head", ""), HasSubstr("the box's own roles were others on that evening"));
  show::Show other = SmallShow();
  other.name = "other";
  ASSERT_TRUE(show::SavePack(other, pack_));
  EXPECT_THAT(refusal("head", ""), HasSubstr("it is of another show than"));
  EXPECT_FALSE(
      stage::OpenEvening({.log = "/nowhere", .without = "head", .at = ""}, pack_, roles_, studio_->show()));
}

}  // namespace
}  // namespace kaori::tests
