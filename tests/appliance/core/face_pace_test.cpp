// Work beside the face: how often it may go on, by what it costs the face.
#include "appliance/core/board/face_pace.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <thread>

#include "appliance/core/board/board.h"

namespace kaori::board {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.

// A stage that draws more slowly while somebody works beside it, and what came of that.
struct Face {
  double frames_per_s = 10;
  // Of that rate, while there is work.
  double while_working = 1;
  double drawn = 0;
  Time now = Time{} + 1000s;
  FacePace pace{};

  bool Ask() { return pace.MayWork(static_cast<std::uint32_t>(drawn), now); }

  // Asks twenty times a second, and gives the share of the time in which there was work.
  double Work(Duration span) {
    constexpr Duration kStep = 50ms;
    Duration worked{};
    for (const Time end = now + span; now < end; now += kStep) {
      const bool works = Ask();
      if (works) worked += kStep;
      drawn += Seconds(kStep) * frames_per_s * (works ? while_working : 1);
    }
    return Seconds(worked) / Seconds(span);
  }
};

TEST(FacePace, WorkThatCostsFramesRestsUntilTheFaceKeepsItsRateOnTheWhole) {
  for (const double rate : {7.0, 25.0, 60.0})
    for (const double kept : {0.95, 0.9, 0.8, 0.7}) {
      Face face{.frames_per_s = rate, .while_working = kept};
      const double share = face.Work(20min);
      EXPECT_GE(face.drawn / (rate * 1200), 0.95) << rate << " frames/s, of which work leaves " << kept;
      EXPECT_GE(share, 0.09);
    }
}

TEST(FacePace, WorkThatCostsNothingHardlyRests) {
  Face face{.frames_per_s = 60};
  EXPECT_GE(face.Work(2min), 0.85);
}

// An emulated machine, as the bench has it, draws two pictures a second.
TEST(FacePace, ASlowFaceIsCountedForLonger) {
  Face face{.frames_per_s = 2, .while_working = 0.83};
  const double share = face.Work(20min);
  EXPECT_GE(face.drawn / 2400, 0.95);
  EXPECT_GE(share, 0.15);
}

// A machine on which any work halts the face would never be done with it.
TEST(FacePace, GoesOnInAnyCase) {
  Face face{.frames_per_s = 5, .while_working = 0};
  EXPECT_GE(face.Work(20min), 0.1);
}

TEST(FacePace, WhereThereIsNoStageTheWorkGoesOn) {
  Face face{.frames_per_s = 0};
  EXPECT_GE(face.Work(10min), 0.8);
}

TEST(FacePace, BeginsWithARestToSeeHowFastTheFaceIs) {
  Face face;
  EXPECT_FALSE(face.Ask());
  EXPECT_EQ(face.Work(FacePace::kShortestTurn - 50ms), 0);
}

// What it learnt of a scene that was dearer is soon outweighed.
TEST(FacePace, FollowsAShowThatChanges) {
  Face face{.while_working = 0.5};
  const double before = face.Work(5min);
  face.while_working = 1;
  face.Work(10min);
  EXPECT_GT(face.Work(5min), 3 * before);
}

TEST(FacePace, AStageThatStartsAnewAndWorkAfterALongWhileBeginAnew) {
  Face face;
  face.Work(1min);
  face.drawn = 0;
  EXPECT_FALSE(face.Ask()) << "the stage counts from the beginning";
  face.Work(1min);
  while (face.Ask()) face.Work(50ms);
  face.now += FacePace::kForgets + 1s;
  EXPECT_FALSE(face.Ask()) << "the rest that was on is over, but this is the next piece of work";
  EXPECT_EQ(face.Work(FacePace::kShortestTurn - 50ms), 0);
}

// A show is copied for next to nothing, and then tried.
TEST(FacePace, WorkThatBecomesDearerIsNoticedWithinAFewTurns) {
  Face face{.frames_per_s = 25, .while_working = 0.99};
  face.Work(3min);
  face.while_working = 0.7;
  face.Work(1min);
  const double before = face.drawn;
  face.Work(3min);
  EXPECT_GE((face.drawn - before) / (25 * 180), 0.95);
}

class FacePaceByBoard : public ::testing::Test {
 protected:
  FacePaceByBoard() {
    std::string name = (std::filesystem::temp_directory_path() / "kaori-pace-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~FacePaceByBoard() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

TEST_F(FacePaceByBoard, WithoutABoardOrAStageNobodyIsRestedFor) {
  const auto may_work = PaceByBoardAt(folder_ / "board");
  EXPECT_TRUE(may_work()) << "there is no board";
  const auto board = Board::Create(folder_ / "board");
  ASSERT_TRUE(board);
  EXPECT_TRUE(may_work()) << "no stage has written it";
}

// Eight frames in a second end the first rest, and nothing else does so soon.
TEST_F(FacePaceByBoard, CountsTheFramesThatTheStageWrites) {
  const auto board = Board::Create(folder_ / "board");
  ASSERT_TRUE(board);
  auto stage = board->AcquireWriter<StageStatus>();
  ASSERT_TRUE(stage);
  const SteadyClock clock;
  const auto may_work = PaceByBoardAt(folder_ / "board"), copy = may_work;
  const auto write = [&](std::uint32_t frames) {
    stage->Write({.frames = frames}, clock.now(), SourceState::kLive);
  };
  write(100);
  EXPECT_FALSE(may_work()) << "it begins with a rest";
  std::this_thread::sleep_for(FacePace::kShortestTurn);
  EXPECT_FALSE(copy()) << "no frame has come";
  write(100 + FacePace::kTurnFrames);
  EXPECT_TRUE(copy());
}

}  // namespace
}  // namespace kaori::board
