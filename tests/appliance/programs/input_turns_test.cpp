// What one turn of a dial has is learnt from a turn, kept in a file, and played from then on.
#include <gmock/gmock.h>

#include "appliance/programs/input/learnt_turns.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"
#include "tests/appliance/programs/input_fixture.h"
#include "tests/appliance/programs/input_turn_lesson.h"

namespace kaori::input {
namespace {

using board::LearnCall;
using std::chrono::milliseconds;
using ::testing::HasSubstr;

const ports::HidIdentity kKnob{
    .port = "1", .vendor = 0x1234, .product = 0xABCD, .name = "A \"knob\"\n", .descriptor = {}};
const ports::HidIdentity kOther{
    .port = "2", .vendor = 0x1234, .product = 0xABCD, .name = "Another", .descriptor = {}};

TEST(UsualCountsOfATurn, AreThoseWithinFourPercent) {
  for (const auto& [turned, wanted] : {std::pair{203, 200},
                                       {196, 200},
                                       {93, 96},
                                       {250, 256},
                                       {1010, 1000},
                                       {1040, 1024},
                                       {24, 24},
                                       {300, 300},
                                       {49, 48},
                                       {80, 80}})
    EXPECT_EQ(UsualCounts(turned), wanted) << turned;
}

class LearntTurnsTest : public ::testing::Test {
 protected:
  board::BoardFile files_;
  const std::filesystem::path file_ = files_.folder() / "turns.toml";
};

TEST_F(LearntTurnsTest, StandInAFileByDeviceAndNotBySocket) {
  LearntTurns turns(file_);
  EXPECT_EQ(turns.CountsOf(kKnob), 0);
  ASSERT_TRUE(turns.Keep(kKnob, 96));
  ASSERT_TRUE(turns.Keep(kOther, 200));
  ASSERT_TRUE(turns.Keep(kKnob, 100));
  LearntTurns again(file_);
  ports::HidIdentity elsewhere = kKnob;
  elsewhere.port = "7";
  EXPECT_EQ(again.CountsOf(elsewhere), 100);
  EXPECT_EQ(again.CountsOf(kOther), 200);
  EXPECT_THAT(ReadFile(file_).value_or(""),
              HasSubstr("usb = \"1234:abcd\"\nname = \"A knob\"\ncounts_per_turn = 100"));
}

TEST_F(LearntTurnsTest, WhatIsWrongInTheFileIsNamedAndTheRestCounts) {
  ASSERT_TRUE(WriteWholeFile(
      file_, {AsBytes("[[device]]\nusb = \"1234:abcd\"\nname = \"Another\"\ncounts_per_turn = 94\n"
                      "[[device]]\nusb = 3\n")}));
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(LearntTurns(file_).CountsOf(kOther), 94);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(),
              HasSubstr("turns.toml:5: is no device with its counts"));
  ASSERT_TRUE(WriteWholeFile(file_, {AsBytes("[[device\n")}));
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(LearntTurns(file_).CountsOf(kOther), 0);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("what was learnt of turns does not count"));
}

class TaughtTurns : public InputFixture {
 protected:
  TaughtTurns() {
    KillService();
    Restart();
    Play(milliseconds(20));
  }
  void Restart() {
    bus_ = hid::LocalHidBus::Watch(links()).value();
    service_.emplace(board_, InputWriters::Acquire(board_).value(),
                     InputSources{.buses = {bus_.get()}, .lines = {}, .turns = turns_}, settings_, clock_);
  }
  void Turn(int dial, double turns) {
    rig_->devices().dial_box.Turn(dial, turns);
    Play(milliseconds(20));
  }
  std::optional<LearnCall> Teach(std::uint32_t dial, std::uint32_t counts) {
    return lesson_.Keep(dial, counts, clock_.now(), [this] { Play(milliseconds(5)); });
  }
  std::int32_t Counts(std::size_t dial) const { return Board().surface.value.counts[dial]; }

  std::filesystem::path turns_ = file_.folder() / "turns.toml";
  TurnLesson lesson_{board_};
};

// The box's encoders have 256 counts; of 64 it is a quarter of a turn that a person calls a whole one.
TEST_F(TaughtTurns, ATurnThatWasLearntIsATurnOnTheBoardAtOnceAndAfterARestart) {
  Turn(2, 0.25);
  EXPECT_EQ(Counts(2), 64);
  EXPECT_EQ(Teach(2, 66), LearnCall::kTurnKept) << "a hand is not exact";
  const auto before = Counts(2);
  Turn(2, 0.25);
  EXPECT_EQ(Counts(2) - before, 256);
  KillService();
  Restart();
  Play(milliseconds(20));
  Turn(5, -0.25);
  EXPECT_EQ(Counts(5), -256) << "all dials of the device are alike";
  EXPECT_EQ(Teach(5, 1024), LearnCall::kTurnKept) << "and it can be taught again: four such turns were one";
  const auto after = Counts(5);
  Turn(5, 1);
  EXPECT_EQ(Counts(5) - after, 256);
}

TEST_F(TaughtTurns, ALessonOfADialThatNobodyTurnedIsRefusedAndALessonOfBeforeIsNotTakenTwice) {
  EXPECT_EQ(Teach(3, 200), LearnCall::kTurnRefused);
  Turn(3, 1);
  EXPECT_EQ(Teach(3, 200), LearnCall::kTurnKept);
  std::filesystem::remove(turns_);
  KillService();
  Restart();
  Play(milliseconds(50));
  EXPECT_FALSE(std::filesystem::exists(turns_));
}

TEST_F(TaughtTurns, WhereItCannotBeKeptItIsRefusedAndNothingChanges) {
  std::filesystem::create_directories(turns_);
  Turn(1, 1);
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Teach(1, 200), LearnCall::kTurnRefused);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("what one turn has is not kept: "));
  const auto before = Counts(1);
  Turn(1, 1);
  EXPECT_EQ(Counts(1) - before, 256);
}

}  // namespace
}  // namespace kaori::input
