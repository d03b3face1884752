// The stage: screens that come, go and change, a second stage, one that takes over, and no heap on the way.
#include "appliance/programs/stage/stage.h"
#include "appliance/core/board/caller.h"
#include "appliance/core/board/press_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "appliance/core/board/performance_state.h"
#include "hw-sim/evening/allocations.h"
#include "tests/appliance/core/pack_fixture.h"
#include "tests/appliance/programs/stage_screen.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using ::testing::HasSubstr;
constexpr Duration kStageFrame = 16'666'667ns;

class StageTest : public PackTest {
 protected:
  static void SetUpTestSuite() {
    show::Show show = SmallShow();
    for (std::uint16_t i = 0; i < 4; ++i) show.buttons[i] = {show::CallKind::kFace, i};
    for (std::uint16_t i = 0; i < 3; ++i) show.buttons[4U + i] = {show::CallKind::kExpression, i};
    for (std::uint16_t i = 0; i < 5; ++i) show.buttons[7U + i] = {show::CallKind::kStyle, i};
    show.buttons[12] = {show::CallKind::kScene, 0};
    auto studio = stage::Studio::Open(std::move(show));
    ASSERT_TRUE(studio) << studio.error().message();
    studio_ = std::move(*studio);
  }
  static void TearDownTestSuite() { studio_.reset(); }

  StageTest()
      : board_(board::Board::Create((folder_ / "board").string()).value()),
        surface_(board_.AcquireWriter<board::Surface>().value()) {
    clock_.Advance(100s);
    Touch();
  }

  std::unique_ptr<stage::Stage> Open() {
    return std::make_unique<stage::Stage>(board_, stage::StageWriters::Acquire(board_).value(), *studio_,
                                          clock_);
  }
  void Touch() { surface_.Write(surface_value_, clock_.now(), board::SourceState::kLive); }

  // A vertical blank, and what the stage makes of it.
  void Frame(stage::Stage& stage) {
    clock_.Advance(kStageFrame);
    screen_.flip = ports::Flip{clock_.now(), screen_.presented, kStageFrame};
    stage.Step();
  }

  static std::unique_ptr<stage::Studio> studio_;
  ManualClock clock_;
  board::Board board_;
  board::Writer<board::Surface> surface_;
  board::Surface surface_value_;
  ScreenHand screen_;
};
std::unique_ptr<stage::Studio> StageTest::studio_;

TEST_F(StageTest, TakesNothingFromTheHeapOnItsFramePath) {
  showlog::Recorder log([&log] { log.Release(); });  // As on a box.
  const auto stage = Open();
  stage->SetScreen(std::make_unique<HeldScreen>(screen_));
  stage->SetLog(&log);
  const auto play = [&](int frames) {
    for (int frame = 0; frame < frames; ++frame) {
      if (frame % 7 == 0)
        board::NotePress(surface_value_, static_cast<std::size_t>(frame / 7 % 13), clock_.now());
      surface_value_.counts[static_cast<std::size_t>(frame % 8)] += frame % 5 - 2;
      Touch();
      Frame(*stage);
    }
  };
  play(200);  // Every call was seen once: shaders are compiled, buffers have their size.
  const std::size_t before = sim::AllocationCount();
  play(600);
  EXPECT_EQ(sim::AllocationCount() - before, 0U);
  EXPECT_EQ(screen_.presented, 800U);
  const std::size_t counted = sim::AllocationCount();
  const auto proof = std::make_unique<int>(1);
  EXPECT_EQ(sim::AllocationCount(), counted + 1) << "the heap is not counted";
}

TEST_F(StageTest, FollowsAScreenThatChangesItsSize) {
  const auto stage = Open();
  stage->SetScreen(std::make_unique<HeldScreen>(screen_));
  for (const auto& [width_px, height_px] : {std::pair{64, 36}, {200, 120}, {1, 1}, {33, 77}}) {
    screen_.width_px = width_px;
    screen_.height_px = height_px;
    std::ranges::fill(screen_.picture, std::uint8_t{0});
    Frame(*stage);
    ASSERT_TRUE(stage->has_screen()) << width_px << " x " << height_px;
    EXPECT_TRUE(screen_.Shows()) << width_px << " x " << height_px;
  }
}

TEST_F(StageTest, PlaysOnWithoutItsScreenAndShowsAgainWhenItReturns) {
  const auto stage = Open();
  stage->SetScreen(std::make_unique<HeldScreen>(screen_));
  Frame(*stage);
  screen_.plugged = false;
  Frame(*stage);
  EXPECT_FALSE(stage->has_screen());
  stage->Step();  // Without a screen: nothing.
  board::NotePress(surface_value_, 2, clock_.now());
  Touch();
  for (int i = 0; i < 30; ++i) {
    clock_.Advance(33ms);
    stage->StepUnseen();
  }
  EXPECT_EQ(stage->state().faces.to, 2);
  EXPECT_TRUE(board_.Read<board::Lamps>().value.lit & 4U) << "lamps answer without a screen";
  screen_.plugged = true;
  stage->SetScreen(std::make_unique<HeldScreen>(screen_));
  const auto shown = screen_.presented;
  Frame(*stage);
  EXPECT_GT(screen_.presented, shown);
}

TEST_F(StageTest, IsNotCarriedAwayByAScreenWhoseClockIsWrong) {
  const auto stage = Open();
  stage->SetScreen(std::make_unique<HeldScreen>(screen_));
  board::NotePress(surface_value_, 2, clock_.now());
  Touch();
  for (int i = 0; i < 120; ++i) {
    clock_.Advance(kStageFrame);
    screen_.flip = ports::Flip{clock_.now() + 1h, screen_.presented, kStageFrame};
    stage->Step();
    ASSERT_LE(stage->state().last, clock_.now() + 100ms);
  }
  EXPECT_FLOAT_EQ(stage->state().faces.progress, 1) << "time goes on all the same";
}

TEST_F(StageTest, SamplesTheInputJustBeforeTheFlipWhenItIsToldTo) {
  const auto stage = Open();
  stage->SampleLate();
  stage->SetScreen(std::make_unique<HeldScreen>(screen_));
  stage->Step();
  ASSERT_EQ(screen_.presented, 1U) << "the first picture waits for nothing";
  screen_.flip = ports::Flip{clock_.now(), 1, kStageFrame};
  stage->Step();
  EXPECT_EQ(screen_.presented, 1U) << "there is time";
  ASSERT_TRUE(stage->wakes_at());
  EXPECT_GT(*stage->wakes_at(), clock_.now() + kStageFrame / 2);
  EXPECT_LT(*stage->wakes_at(), clock_.now() + kStageFrame);
  clock_.Advance(*stage->wakes_at() - clock_.now());
  board::NotePress(surface_value_, 2, clock_.now());
  Touch();
  stage->Step();
  EXPECT_EQ(screen_.presented, 2U);
  EXPECT_EQ(stage->state().faces.to, 2) << "what was pressed meanwhile is in the picture";
}

TEST_F(StageTest, TellsWhenAFrameWasPresentedAndWhenItsInputWasSampled) {
  const auto stage = Open();
  stage->SetScreen(std::make_unique<HeldScreen>(screen_));
  stage->Step();
  const Time read = clock_.now();
  Frame(*stage);
  const Time presented = clock_.now();
  const auto status = board_.Read<board::StageStatus>().value;
  EXPECT_EQ(status.flipped_at, presented);
  EXPECT_EQ(status.sampled_at, read);
  EXPECT_EQ(status.missed_flips, 0U);
}

TEST_F(StageTest, CountsTheFlipsThatCameLate) {
  const auto stage = Open();
  stage->SetScreen(std::make_unique<HeldScreen>(screen_));
  for (int i = 0; i < 10; ++i) Frame(*stage);
  clock_.Advance(kStageFrame);
  Frame(*stage);
  Frame(*stage);
  EXPECT_EQ(board_.Read<board::StageStatus>().value.missed_flips, 1U);
}

TEST_F(StageTest, RefusesASecondStageOnOneBoard) {
  const auto stage = Open();
  const auto second = stage::StageWriters::Acquire(board_);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().cause, std::errc::device_or_resource_busy);
  EXPECT_THAT(second.error().attempt, HasSubstr("held by process " + std::to_string(::getpid())));
}

TEST_F(StageTest, GoesOnWhereAStageThatDiedLeftOff) {
  auto stage = Open();
  EXPECT_FALSE(stage->resumed());
  board::NotePress(surface_value_, 3, clock_.now());
  Touch();
  for (int i = 0; i < 12; ++i) {
    clock_.Advance(33ms);
    stage->StepUnseen();
  }
  const performance::State left = stage->state();
  ASSERT_LT(left.faces.progress, 1) << "it dies in the middle of a fade";
  stage.reset();
  clock_.Advance(2s);
  stage = Open();
  EXPECT_TRUE(stage->resumed());
  stage->StepUnseen();
  EXPECT_EQ(stage->state().faces.to, 3);
  EXPECT_GE(stage->state().faces.progress, left.faces.progress);
  EXPECT_LT(stage->state().faces.progress, left.faces.progress + 0.2F);
}

TEST_F(StageTest, OpensAnewOverWhatIsNoSoundState) {
  performance::State state;
  state.faces.to = 77;
  {
    auto writer = board_.AcquireWriter<board::Performance>().value();
    writer.Write(board::Hold(state), clock_.now(), board::SourceState::kLive);
  }
  auto stage = Open();
  EXPECT_FALSE(stage->resumed());
  stage->StepUnseen();
  EXPECT_TRUE(performance::IsValid(stage->state(), studio_->show()));
}

TEST_F(StageTest, TellsWhoHasEachLevelAndFromWhereRolesArePlayed) {
  const auto stage = Open();
  auto caller = board::Caller::Acquire(board_, board::CallWriter::kControl).value();
  const auto play = [&](int frames) {
    for (int i = 0; i < frames; ++i, clock_.Advance(kStageFrame)) stage->StepUnseen();
    return board_.Read<board::ShowNow>().value;
  };
  const auto life = static_cast<std::size_t>(show::Level::kLife);
  EXPECT_EQ(play(5).levels[life].owner, board::LevelOwner::kNobody);
  caller.Make({.at = clock_.now(), .verb = board::CallVerb::kLevel, .subject = 6, .value = 0.25F});
  for (const std::uint32_t role : {1U, 77U})
    caller.Make({.at = clock_.now(), .verb = board::CallVerb::kLoadRole, .subject = role, .value = 1});
  board::ShowNow now = play(50);
  EXPECT_EQ(now.levels[life].owner, board::LevelOwner::kRemote);
  EXPECT_FLOAT_EQ(now.levels[life].value, 0.25F);
  EXPECT_EQ(now.role_devices[1], static_cast<std::uint32_t>(show::Device::kRightStick));
  EXPECT_EQ(now.calls_refused, 1U) << "there is no role 77";
  surface_value_.counts[6] += 64;
  Touch();
  EXPECT_EQ((now = play(5)).levels[life].owner, board::LevelOwner::kRole);
  EXPECT_FLOAT_EQ(now.levels[life].value, 0.5F);
}

TEST_F(StageTest, TellsItsFramesPerSecondFromTheFirstSecondOn) {
  const auto stage = Open();
  stage->SetScreen(std::make_unique<HeldScreen>(screen_));
  for (int i = 0; i < 62; ++i) Frame(*stage);
  EXPECT_NEAR(board_.Read<board::StageStatus>().value.frames_per_s, 60, 2);
}

TEST_F(StageTest, MeasuresHowOldTheLipsAreWhenTheyArePresented) {
  const auto stage = Open();
  stage->SetScreen(std::make_unique<HeldScreen>(screen_));
  auto lips = board_.AcquireWriter<board::Lips>().value();
  for (int i = 0; i < 130; ++i) {
    // Of a camera that sees as often as the screen shows, and is read 7 ms before the flip.
    lips.Write({.quality = 1}, clock_.now() - 7ms, board::SourceState::kLive);
    Frame(*stage);
  }
  const board::StageStatus status = board_.Read<board::StageStatus>().value;
  // Written before the flip, drawn at it, and presented at the next one.
  EXPECT_NEAR(Seconds(status.lips_age), 0.007 + 2.0 / 60, 0.0002);
  EXPECT_EQ(status.voice_age, Duration{}) << "there is none";
  EXPECT_GT(status.mouth_lag, status.lips_age + kStageFrame / 2);
  EXPECT_LT(status.mouth_lag, status.lips_age + 50ms);
}

TEST_F(StageTest, TellsWhichMotionPlaysAndWhenItBegan) {
  const auto stage = Open();
  auto keys = board_.AcquireWriter<board::Keys>().value();
  stage->SetScreen(std::make_unique<HeldScreen>(screen_));
  board::Keys struck;
  keys.Write(struck, clock_.now(), board::SourceState::kLive);
  for (int i = 0; i < 3; ++i) Frame(*stage);
  EXPECT_EQ(board_.Read<board::MotionNow>().source, board::SourceState::kAbsent);
  const show::Motion& take = studio_->show().motions.at(0);
  board::NotePress(struck, take.key_usage, clock_.now());
  keys.Write(struck, clock_.now(), board::SourceState::kLive);
  std::optional<Time> began;
  for (int i = 0; i < 10; ++i) {
    Frame(*stage);
    const auto now = board_.Read<board::MotionNow>();
    ASSERT_EQ(now.value.motion, 0);
    EXPECT_EQ(now.value.starts, 1U);
    const Time begins = now.at - FromSeconds(now.value.at_s);
    if (began) {
      EXPECT_NEAR(Seconds(begins - *began), 0, 1e-4);
    }
    began = begins;
  }
  for (int i = 0; i < 1000 && board_.Read<board::MotionNow>().value.motion >= 0; ++i) Frame(*stage);
  EXPECT_EQ(board_.Read<board::MotionNow>().value.motion, -1);
}

}  // namespace
}  // namespace kaori::tests
