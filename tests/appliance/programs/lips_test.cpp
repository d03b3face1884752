// The lip camera's pictures, and what they become on the board.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/programs/lips/lip_reader.h"
#include "drivers/camera/local_camera.h"
#include "hw-sim/links/local/rig.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::lips {
namespace {

using board::SourceState;
using ports::PixelFormat;
using std::chrono::milliseconds;
using ::testing::FloatNear;

// The reader before the simulated camera, on the local link, in simulated time.
class Lips : public ::testing::Test {
 protected:
  Lips() : board_(file_.Open()) {
    rig_ = sim::Rig::Open({.folder = links()}, clock_).value();
    StartReader();
  }

  std::string links() const { return (file_.folder() / "links").string(); }

  void StartReader(const LipSettings& settings = {}) {
    reader_.emplace([folder = links()] { return camera::LocalCamera::Open(folder); }, board_,
                    board_.AcquireWriter<board::Lips>().value(), settings, clock_);
  }

  void Play(Duration time) {
    for (Duration t{}; t < time; t += milliseconds(5)) {
      clock_.Advance(milliseconds(5));
      if (rig_) rig_->Pump();
      if (reader_) reader_->Step();
    }
  }

  void LearnRest() { Play(milliseconds(1300)); }
  board::Stamped<board::Lips> Read() const { return board_.Read<board::Lips>(); }
  sim::LipCamera& camera() { return rig_->camera(); }

  board::BoardFile file_;
  board::Board board_;
  ManualClock clock_;
  std::unique_ptr<sim::Rig> rig_;
  std::optional<LipReader> reader_;
};

TEST_F(Lips, LearnTheMouthAtRestInTheFirstSecond) {
  LearnRest();
  EXPECT_EQ(Read().source, SourceState::kLive);
  EXPECT_THAT(Read().value.rest_width, FloatNear(static_cast<float>(sim::kRestMouthOfPicture), 0.02F));
  EXPECT_THAT(Read().value.width, FloatNear(1, 0.02F));
  EXPECT_GT(Read().value.quality, 0.8F);
}

TEST_F(Lips, FollowTheMouthsHeightAndWidth) {
  LearnRest();
  for (const auto& [height, width] : {std::pair{0.25, 1.0}, {0.8, 0.9}, {0.6, 0.5}, {0.3, 1.4}, {1.2, 0.7}}) {
    camera().SetMouth(height, width);
    Play(milliseconds(400));
    EXPECT_THAT(Read().value.height, FloatNear(static_cast<float>(height), 0.05F))
        << height << " x " << width;
    EXPECT_THAT(Read().value.width, FloatNear(static_cast<float>(width), 0.05F)) << height << " x " << width;
    EXPECT_GT(Read().value.quality, 0.5F) << height << " x " << width;
  }
}

TEST_F(Lips, MeasureTheSameInEveryFormatAndSize) {
  LearnRest();
  camera().SetMouth(0.7, 0.8);
  const ports::CameraFormat formats[] = {{640, 480, PixelFormat::kNv12},
                                         {640, 480, PixelFormat::kMjpeg},
                                         {320, 240, PixelFormat::kYuyv},
                                         {1280, 720, PixelFormat::kYuyv}};
  for (const ports::CameraFormat& format : formats) {
    camera().SetFormat(format);
    Play(milliseconds(600));
    EXPECT_EQ(Read().source, SourceState::kLive);
    EXPECT_THAT(Read().value.height, FloatNear(0.7F, 0.06F)) << format.width_px << ", " << int(format.pixels);
    EXPECT_THAT(Read().value.width, FloatNear(0.8F, 0.06F)) << format.width_px << ", " << int(format.pixels);
  }
}

TEST_F(Lips, HoldTheirSizesWithoutQualityWhenTheLensIsCovered) {
  LearnRest();
  camera().SetMouth(0.7, 0.8);
  Play(milliseconds(400));
  const board::Lips before = Read().value;
  camera().CoverLens(true);
  Play(milliseconds(300));
  EXPECT_EQ(Read().value.quality, 0.0F);
  EXPECT_EQ(Read().value.height, before.height);
  camera().CoverLens(false);
  Play(milliseconds(200));
  EXPECT_GT(Read().value.quality, 0.5F);
}

TEST_F(Lips, AreStaleAfterTwoHundredMillisecondsOfAStallAndLiveWithinASecondAfterIt) {
  LearnRest();
  camera().Stall(true);
  Play(milliseconds(260));
  EXPECT_EQ(Read().source, SourceState::kStale);
  Play(milliseconds(7000));
  camera().Stall(false);
  Play(milliseconds(1000));
  EXPECT_EQ(Read().source, SourceState::kLive);
}

TEST_F(Lips, ComeBackWithTheCamera) {
  LearnRest();
  const float rest = Read().value.rest_width;
  for (int round = 0; round < 10; ++round) {
    ASSERT_TRUE(rig_->Unplug("camera"));
    Play(milliseconds(10));
    EXPECT_EQ(Read().source, SourceState::kStale) << "at once: it is gone";
    Play(milliseconds(100 * round));
    ASSERT_TRUE(rig_->Plug("camera"));
    Play(milliseconds(500));
    EXPECT_EQ(Read().source, SourceState::kLive);
    EXPECT_THAT(Read().value.rest_width, FloatNear(rest, 0.001F));
  }
}

TEST_F(Lips, DropGarbageAndMeasureOn) {
  LearnRest();
  testing::internal::CaptureStderr();
  const board::Lips before = Read().value;
  for (int round = 0; round < 20; ++round) {
    round % 2 == 0 ? camera().SendGarbage() : camera().Scramble();
    Play(milliseconds(100));
    ASSERT_TRUE(board::Valid(Read().value));
  }
  const std::string log = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::ranges::count(log, '\n'), 1) << "and says so once: " << log;
  Play(milliseconds(300));
  EXPECT_EQ(Read().source, SourceState::kLive);
  EXPECT_THAT(Read().value.height, FloatNear(before.height, 0.02F));
  EXPECT_THAT(Read().value.width, FloatNear(before.width, 0.02F));
}

TEST_F(Lips, MeasureOnAsBeforeWhenTheProgramIsKilledInTheMiddleOfAWord) {
  LearnRest();
  camera().SetMouth(0.9, 0.7);
  Play(milliseconds(400));
  const board::Lips before = Read().value;
  reader_.reset();
  Play(milliseconds(100));
  EXPECT_EQ(Read().value.height, before.height);
  StartReader();
  Play(milliseconds(1500));
  EXPECT_THAT(Read().value.height, FloatNear(before.height, 0.02F));
  EXPECT_THAT(Read().value.width, FloatNear(before.width, 0.02F));
  EXPECT_GT(Read().value.frames, before.frames);
}

TEST_F(Lips, AreAbsentWhileThereIsNoCamera) {
  reader_.reset();
  ASSERT_TRUE(rig_->Unplug("camera"));
  StartReader();
  Play(milliseconds(1000));
  EXPECT_EQ(Read().source, SourceState::kAbsent);
  ASSERT_TRUE(rig_->Plug("camera"));
  Play(milliseconds(400));
  EXPECT_EQ(Read().source, SourceState::kLive);
}

}  // namespace
}  // namespace kaori::lips
