// The board as the agent tells of it and as the bench reads it.
#include <gtest/gtest.h>

#include <stdlib.h>

#include <filesystem>
#include <optional>
#include <string>
#include <tuple>

#include "appliance/core/board/board.h"
#include "hw-sim/hil/board_view.h"
#include "tests/hil/agent/board_json.h"

namespace kaori::hil {
namespace {

using board::SourceState;

// A board whose programs all run, as a bench in another process sees it.
class AgentBoard : public ::testing::Test {
 protected:
  ~AgentBoard() override { std::filesystem::remove_all(folder_); }
  static std::string Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "kaori-board-XXXXXX").string();
    return ::mkdtemp(pattern.data());
  }
  // The agent opens the board for each question.
  Result<BoardView> Look() const {
    const auto seen = board::Board::Open(path_);
    if (!seen) return tl::unexpected(seen.error());
    return ReadBoardView(agent::BoardAsJson(*seen, clock_));
  }

  ManualClock clock_;
  const std::string folder_ = Folder();
  const std::string path_ = folder_ + "/board";
  board::Board board_ = board::Board::Create(path_).value();
  board::Writer<board::Surface> surface_ = board_.AcquireWriter<board::Surface>().value();
  board::Writer<board::Stick> right_ = board_.AcquireWriter<board::Stick>(1).value();
  board::Writer<board::Lips> lips_ = board_.AcquireWriter<board::Lips>().value();
  board::Writer<board::ShowNow> show_ = board_.AcquireWriter<board::ShowNow>().value();
  std::optional<board::Writer<board::StageStatus>> stage_ =
      board_.AcquireWriter<board::StageStatus>().value();
  std::optional<board::Writer<board::Desk>> desk_ = board_.AcquireWriter<board::Desk>().value();
};

TEST_F(AgentBoard, IsWhatTheBenchReads) {
  board::Surface surface;
  surface.counts[2] = -64;
  surface.pushes[31] = 7;
  surface_.Write(surface, clock_.now(), SourceState::kLive);
  right_.Write({.x = -0.5F, .y = 0.25F, .port = 99}, clock_.now(), SourceState::kStale);
  board::StageStatus stage;
  stage.frames = 12;
  stage_->Write(stage, clock_.now(), SourceState::kLive);
  board::ShowNow show{.cue_active = 3, .cue_standby = 4, .cue_pending = 5};
  for (float value = 0; auto& level : show.levels) level.value = value++;
  show_.Write(show, clock_.now(), SourceState::kLive);
  desk_->Write({.code = 123456}, clock_.now(), SourceState::kLive);
  const auto view = Look();
  ASSERT_TRUE(view) << view.error().message();
  EXPECT_EQ(view->desk_code, 123456);
  EXPECT_TRUE(view->surface_live);
  EXPECT_EQ(view->counts[2], -64);
  EXPECT_EQ(view->pushes[31], 7U);
  EXPECT_FALSE(view->right.live);
  EXPECT_EQ(view->right.x, -0.5);
  EXPECT_EQ(view->right.port, 99U);
  EXPECT_FALSE(view->left.live);
  EXPECT_TRUE(view->stage.live);
  EXPECT_EQ(view->stage.frames, 12U);
  EXPECT_EQ(std::tuple(view->cue_active, view->cue_standby, view->cue_pending), std::tuple(3, 4, 5));
  EXPECT_EQ(std::tuple(view->head_yaw_rad, view->gaze_yaw_rad), std::tuple(8, 12));
  EXPECT_EQ(view->now_ns, clock_.now().time_since_epoch().count());
}

TEST_F(AgentBoard, IsNotLiveAnyMoreWhereItsProgramHasEnded) {
  stage_->Write({.frames = 12}, clock_.now(), SourceState::kLive);
  desk_->Write({.code = 123456}, clock_.now(), SourceState::kLive);
  stage_.reset();
  desk_.reset();
  const auto view = Look();
  ASSERT_TRUE(view) << view.error().message();
  EXPECT_FALSE(view->stage.live);
  EXPECT_EQ(view->stage.frames, 12U) << "what it wrote last stays";
  EXPECT_EQ(view->desk_code, -1);
}

TEST_F(AgentBoard, ThatTookAnothersPlaceIsLiveOnceItsProgramsHaveMoved) {
  surface_.Write({}, clock_.now(), SourceState::kLive);
  std::filesystem::remove(path_);
  const auto fresh = board::Board::Create(path_);
  ASSERT_TRUE(fresh);
  EXPECT_FALSE(fresh->HasWriter<board::Surface>());
  EXPECT_FALSE(Look()->surface_live);
  ASSERT_TRUE(board_.Heal());
  EXPECT_TRUE(fresh->HasWriter<board::Surface>());
  EXPECT_TRUE(Look()->surface_live);
}

TEST_F(AgentBoard, TellsWhenTheOldestAndTheNewestInputCame) {
  const Time first = clock_.now();
  surface_.Write({}, first, SourceState::kLive);
  clock_.Advance(std::chrono::seconds(1));
  right_.Write({}, clock_.now(), SourceState::kLive);
  lips_.Write({.frames = 3}, clock_.now(), SourceState::kLive);
  const auto view = Look();
  ASSERT_TRUE(view) << view.error().message();
  EXPECT_EQ(view->input_at_ns, first.time_since_epoch().count());
  EXPECT_EQ(view->newest_input_ns, clock_.now().time_since_epoch().count());
  EXPECT_EQ(view->lips_at_ns, clock_.now().time_since_epoch().count());
}

TEST(BoardView, RefusesWhatNoAgentSays) {
  for (const char* said : {"", "{}", R"({"surface":7})"}) EXPECT_FALSE(ReadBoardView(said)) << said;
}

}  // namespace
}  // namespace kaori::hil
