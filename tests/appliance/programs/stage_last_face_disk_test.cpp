// The last face on a disk that fails, is full, or gives other bytes back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/appliance/core/small_disk.h"
#include "tests/appliance/programs/stage_last_face_fixture.h"

namespace kaori::stage {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using ::testing::HasSubstr;
using LastFaceDisk = LastFaceTest;

TEST_F(LastFaceDisk, ATornFileAndOneOfAnotherShowAreRefusedInOneLine) {
  EXPECT_EQ(RecallLastFace(place_, show_, board_, now_).error().cause, std::errc::no_such_file_or_directory);
  Play(1s);
  keeper_->KeepNow();
  const std::string whole = File();
  ASSERT_EQ(Refusal(place_), "");
  EXPECT_THAT(Refusal({.file = place_.file, .show = 78}), HasSubstr("it is of another show"));
  for (std::size_t at = 0; at < whole.size(); at += 97) {
    std::string spoilt = whole;
    spoilt[at] = static_cast<char>(spoilt[at] ^ 0x10);
    Write(spoilt);
    EXPECT_THAT(Refusal(place_), HasSubstr("it is torn")) << at;
    Write(whole.substr(0, at));
    EXPECT_THAT(Refusal(place_), HasSubstr("it is torn")) << at;
  }
}

TEST_F(LastFaceDisk, AStateThatTheShowCannotPlayIsRefused) {
  Play(1s);
  keeper_->KeepNow();
  show_.cast.faces.resize(0);
  EXPECT_THAT(Refusal(place_), HasSubstr("another version"));
}

TEST_F(LastFaceDisk, ADiskThatTakesNothingIsSaidOnceAndTriedAgain) {
  place_.file = folder_ / "away" / "last-face";
  Begin();
  ::testing::internal::CaptureStderr();
  Play(95s);
  keeper_->KeepNow();
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("the last face is not kept"));
  EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
  EXPECT_GE(looks_, 3);
  std::filesystem::create_directories(folder_ / "away");
  Play(31s);
  keeper_->KeepNow();
  EXPECT_EQ(Refusal(place_), "");
}

TEST_F(LastFaceDisk, AFullDiskLeavesTheFaceThatWasKeptBefore) {
  Play(1s);
  keeper_->KeepNow();
  Push(3);
  ::testing::internal::CaptureStderr();
  {
    const kaori::tests::SmallDisk full(1000);
    Play(32s);
    keeper_->KeepNow();
  }
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("the last face is not kept"));
  EXPECT_EQ(RecallLastFace(place_, show_, board_, now_)->faces.to, 0);
  Play(31s);
  keeper_->KeepNow();
  EXPECT_EQ(RecallLastFace(place_, show_, board_, now_)->faces.to, 3);
}

}  // namespace
}  // namespace kaori::stage
