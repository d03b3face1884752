// The stage with its handles: what is pulled is in the picture, and what is shut costs nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/core/board/caller.h"
#include "appliance/core/board/press_log.h"
#include "appliance/programs/editor/keys.h"
#include "appliance/programs/stage/stage.h"
#include "hw-sim/evening/allocations.h"
#include "tests/appliance/core/pack_fixture.h"
#include "tests/appliance/programs/stage_screen.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
namespace key = editor::key;

constexpr Duration kFrame = 16'666'667ns;

class StageWithAnEditor : public PackTest {
 protected:
  StageWithAnEditor()
      : board_(board::Board::Create((folder_ / "board").string()).value()),
        keys_(board_.AcquireWriter<board::Keys>().value()),
        surface_(board_.AcquireWriter<board::Surface>().value()) {
    clock_.Advance(100s);
    Touch();
    show::Show show = SmallShow();
    auto author = editor::ExpressionEditor::Open(folder_ / "own", show);
    studio_ = std::move(stage::Studio::Open(std::move(show)).value());
    stage_ = std::make_unique<stage::Stage>(board_, stage::StageWriters::Acquire(board_).value(), *studio_,
                                            clock_);
    stage_->SetEditor(std::move(author));
    stage_->SetScreen(std::make_unique<HeldScreen>(screen_));
  }

  void Touch() {
    keys_.Write(typed_, clock_.now(), board::SourceState::kLive);
    surface_.Write(surface_value_, clock_.now(), board::SourceState::kLive);
  }
  void Frame() {
    clock_.Advance(kFrame);
    Touch();
    screen_.flip = ports::Flip{clock_.now(), screen_.presented, kFrame};
    stage_->Step();
  }
  void Frames(int count) {
    for (int i = 0; i < count; ++i) Frame();
  }
  void Strike(std::uint8_t usage) {
    board::NotePress(typed_, usage, clock_.now());
    Frame();
  }

  ManualClock clock_;
  board::Board board_;
  board::Writer<board::Keys> keys_;
  board::Writer<board::Surface> surface_;
  board::Keys typed_;
  board::Surface surface_value_;
  ScreenHand screen_;
  std::unique_ptr<stage::Studio> studio_;
  std::unique_ptr<stage::Stage> stage_;
};

TEST_F(StageWithAnEditor, IsShutByTheLockAndNotOpenedAgain) {
  auto caller = board::Caller::Acquire(board_, board::CallWriter::kControl).value();
  Frames(3);
  Strike(key::kTab);
  Frames(30);
  ASSERT_TRUE(stage_->expression_editor()->open());
  caller.Make({.at = clock_.now(), .verb = board::CallVerb::kLock, .subject = 1});
  Frames(2);
  EXPECT_FALSE(stage_->expression_editor()->open());
  Strike(key::kTab);
  Frames(3);
  EXPECT_FALSE(stage_->expression_editor()->open());
  EXPECT_EQ(stage_->state().locked_out, 1U);
}

TEST_F(StageWithAnEditor, PullWhatThePictureShows) {
  Frames(3);
  Strike(key::kTab);
  Frames(30);
  ASSERT_TRUE(stage_->expression_editor()->open());
  ASSERT_GE(stage_->expression_editor()->chosen(), 0) << "the one nearest to the middle";
  const auto chosen = static_cast<std::size_t>(stage_->expression_editor()->chosen());
  const face::EyeBall eye = studio_->shape().eyes[0];
  const std::vector<glm::vec3> before(studio_->shape().cage.begin(), studio_->shape().cage.end());
  surface_value_.counts[3] += 128;
  Frame();
  EXPECT_NEAR(stage_->expression_editor()->session().work().pulls_m[chosen].z, 0.005F, 1e-5F);
  float most_m = 0;
  for (std::size_t v = 0; v < before.size(); ++v)
    most_m = std::max(most_m, glm::distance(before[v], studio_->shape().cage[v]));
  EXPECT_GT(most_m, 0.001F) << "in the very frame";
  EXPECT_EQ(studio_->shape().eyes[0].centre, eye.centre);
}

TEST_F(StageWithAnEditor, TakeNothingFromTheHeapWhileTheyAreShut) {
  Strike(key::kTab);
  Frames(30);
  surface_value_.counts[3] += 128;
  Frames(10);
  Strike(key::kTab);
  Frames(200);  // Shaders are readied, the handles are gone.
  const std::size_t before = sim::AllocationCount();
  for (int i = 0; i < 100; ++i) {
    surface_value_.counts[1] += i % 5 - 2;
    Frame();
  }
  EXPECT_EQ(sim::AllocationCount(), before);
}

}  // namespace
}  // namespace kaori::tests
