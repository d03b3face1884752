// A version that is tried stays when its face was seen for a minute, and gives way otherwise.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/programs/update/running.h"
#include "appliance/programs/update/trial.h"
#include "drivers/base/whole_file.h"
#include "hw-sim/devices/boot_loader.h"
#include "tests/appliance/programs/update_fixture.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::update {
namespace {

using ports::Slot;
using std::chrono::seconds;
using ::testing::HasSubstr;
using Verdict = Confirmation::Verdict;

class UpdateTrial : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kVersion = 5;
  UpdateTrial() { notes_.pending = Pending{6, Slot::kB, 0}; }
  Running Runs(std::uint32_t version, std::uint32_t least = 3) const {
    return {.version = version, .least = least, .slot = choice_.running()};
  }
  sim::BootLoader choice_;
  SimulatedNotes notes_;
};

TEST_F(UpdateTrial, StartsTheOtherSlotOnceAndKeepsItWhenItDoesWell) {
  EXPECT_EQ(AfterStart(choice_, notes_).message, Message::kWaits);
  EXPECT_EQ(BeginTry(choice_, notes_, kVersion).message, Message::kRestarts);
  EXPECT_EQ(choice_.SwitchOn(), Slot::kB);
  EXPECT_EQ(AfterStart(choice_, notes_).message, Message::kLooking);
  NoteStart(notes_);
  ASSERT_TRUE(ConfirmTried(choice_, notes_));
  EXPECT_EQ(notes_.pending, std::nullopt);
  EXPECT_EQ(notes_.last_try, "");
  EXPECT_EQ(choice_.SwitchOn(), Slot::kB);
  EXPECT_EQ(AfterStart(choice_, notes_).message, Message::kNothingWaits);
}

TEST_F(UpdateTrial, ThatGivesWayComesBackAndSaysWhy) {
  BeginTry(choice_, notes_, kVersion);
  choice_.SwitchOn();
  ASSERT_TRUE(GiveWay(notes_, {"kaori-lips.service does not run\nat all", "動きません"}, "its log"));
  EXPECT_EQ(choice_.SwitchOn(), Slot::kA);
  const auto found = AfterStart(choice_, notes_);
  EXPECT_EQ(found.message, Message::kGaveWay);
  EXPECT_EQ(found.version, 6U);
  EXPECT_EQ(found.detail, "kaori-lips.service does not run at all");
  EXPECT_EQ(found.japanese, "動きません");
  notes_.last_try = "of a box of before\nits log";
  EXPECT_EQ(AfterStart(choice_, notes_).detail, "of a box of before");
  EXPECT_EQ(AfterStart(choice_, notes_).japanese, "") << "which is no line of its log";
}

TEST_F(UpdateTrial, ThatDiesWithoutAWordIsToldOfAsWell) {
  notes_.last_try = "of a try before";
  BeginTry(choice_, notes_, kVersion);
  choice_.SwitchOn();
  choice_.SwitchOn();
  const auto found = AfterStart(choice_, notes_);
  EXPECT_EQ(found.message, Message::kGaveWay);
  EXPECT_THAT(found.detail, HasSubstr("never came so far"));
  EXPECT_THAT(found.japanese, HasSubstr("起動できなかった"));
}

TEST_F(UpdateTrial, ThatIsCutOffIsToldFromOneThatNeverStarted) {
  BeginTry(choice_, notes_, kVersion);
  choice_.SwitchOn();
  NoteStart(notes_);
  choice_.SwitchOn();
  EXPECT_THAT(AfterStart(choice_, notes_).detail, HasSubstr("it started, and then the power went"));
}

TEST_F(UpdateTrial, IsMadeThreeTimesAtMost) {
  for (std::uint32_t n = 0; n < kMostTries; ++n) {
    EXPECT_EQ(BeginTry(choice_, notes_, kVersion).message, Message::kRestarts);
    choice_.SwitchOn();
    choice_.SwitchOn();
  }
  EXPECT_EQ(BeginTry(choice_, notes_, kVersion).message, Message::kTriedOften);
  EXPECT_EQ(AfterStart(choice_, notes_).message, Message::kTriedOften);
  EXPECT_EQ(choice_.SwitchOn(), Slot::kA);
}

TEST_F(UpdateTrial, IsRefusedOnAPcThatForgets) {
  choice_.ForgetVariables();
  for (std::uint32_t n = 0; n <= kMostTries; ++n)
    EXPECT_EQ(BeginTry(choice_, notes_, kVersion).message, Message::kForgets)
        << "what was not tried does not count";
  EXPECT_EQ(choice_.SwitchOn(), Slot::kA);
  EXPECT_EQ(AfterStart(choice_, notes_).message, Message::kWaits);
}

TEST_F(UpdateTrial, IsNotBegunFromATrialNorWithoutAnUpdateNorWithoutANote) {
  ASSERT_TRUE(choice_.TryOnce(Slot::kB));
  choice_.SwitchOn();
  EXPECT_EQ(BeginTry(choice_, notes_, kVersion).message, Message::kTrialRuns);
  choice_.SwitchOn();
  notes_.fault = std::errc::io_error;
  EXPECT_EQ(BeginTry(choice_, notes_, kVersion).message, Message::kDiskFault);
  EXPECT_EQ(choice_.SwitchOn(), Slot::kA) << "a try that cannot be counted is not made";
  notes_.fault.reset();
  notes_.pending.reset();
  EXPECT_EQ(BeginTry(choice_, notes_, kVersion).message, Message::kNothingWaits);
}

// A system that can play no show.
TEST_F(UpdateTrial, OfTheOtherSystemIsMadeOnceAndStaysWhereItsFaceIsSeen) {
  notes_.pending.reset();
  EXPECT_EQ(TryOther(choice_, notes_, Runs(kVersion)).message, Message::kRestarts);
  EXPECT_EQ(choice_.SwitchOn(), Slot::kB);
  EXPECT_EQ(TryOther(choice_, notes_, Runs(kVersion)).message, Message::kTriedOften)
      << "which cannot play either";
  EXPECT_EQ(AfterStart(choice_, notes_).message, Message::kLooking);
  ASSERT_TRUE(ConfirmTried(choice_, notes_));
  EXPECT_EQ(choice_.SwitchOn(), Slot::kB);
}

TEST_F(UpdateTrial, OfTheOtherSystemThatIsNoneComesBackAndIsNotRepeated) {
  notes_.pending.reset();
  TryOther(choice_, notes_, Runs(kVersion));
  choice_.SwitchOn();
  EXPECT_EQ(choice_.SwitchOn(), Slot::kA);
  EXPECT_EQ(TryOther(choice_, notes_, Runs(kVersion)).message, Message::kTriedOften);
  EXPECT_EQ(choice_.SwitchOn(), Slot::kA);
}

TEST_F(UpdateTrial, OfTheOtherSystemIsNotMadeOnAPcThatForgets) {
  notes_.pending.reset();
  choice_.ForgetVariables();
  EXPECT_EQ(TryOther(choice_, notes_, Runs(kVersion)).message, Message::kForgets);
  EXPECT_EQ(notes_.pending, std::nullopt);
}

// An update from A to B stays; the system that it replaced has a hole that is known since.
TEST_F(UpdateTrial, OfTheSystemBeforeIsNotMadeWhereItIsBelowTheLeast) {
  BeginTry(choice_, notes_, kVersion);
  EXPECT_EQ(notes_.before, (Pending{kVersion, Slot::kA, 0}));
  choice_.SwitchOn();
  ASSERT_TRUE(ConfirmTried(choice_, notes_));
  const auto refused = TryOther(choice_, notes_, Runs(6, 6));
  EXPECT_EQ(refused.message, Message::kBelowLeast);
  EXPECT_EQ(refused.version, kVersion);
  EXPECT_EQ(notes_.pending, std::nullopt);
  EXPECT_EQ(choice_.SwitchOn(), Slot::kB);
  EXPECT_EQ(TryOther(choice_, notes_, Runs(6, 5)).message, Message::kRestarts)
      << "it is as new as it has to be";
  EXPECT_EQ(choice_.SwitchOn(), Slot::kA);
}

TEST_F(UpdateTrial, OfAnOldSystemThatIsPerhapsWrittenInPartIsNotMadeBelowTheLeast) {
  notes_.pending.reset();
  notes_.overwritten = Pending{2, Slot::kB, 0};
  EXPECT_EQ(TryOther(choice_, notes_, Runs(5, 3)).message, Message::kBelowLeast);
  EXPECT_EQ(TryWhatIsThere(choice_, notes_, Runs(5, 2)).message, Message::kNothingWaits)
      << "it is no system to go back to";
  EXPECT_EQ(TryOther(choice_, notes_, Runs(5, 2)).message, Message::kRestarts) << "but better than no face";
}

TEST_F(UpdateTrial, OfTheSystemBeforeIsAPersonsWishAndBoundByTheLeastVersionToo) {
  notes_.pending.reset();
  EXPECT_EQ(TryWhatIsThere(choice_, notes_, Runs(6)).message, Message::kNothingWaits);
  notes_.before = Pending{5, Slot::kB, 0};
  EXPECT_EQ(TryWhatIsThere(choice_, notes_, Runs(6, 6)).message, Message::kBelowLeast);
  choice_.ForgetVariables();
  EXPECT_EQ(TryWhatIsThere(choice_, notes_, Runs(6, 5)).message, Message::kForgets);
  EXPECT_EQ(notes_.pending, std::nullopt);
  EXPECT_EQ(notes_.before, (Pending{5, Slot::kB, 0})) << "it can be wished again";
  notes_.before = Pending{5, Slot::kA, 0};
  EXPECT_EQ(TryWhatIsThere(choice_, notes_, Runs(6, 5)).message, Message::kNothingWaits)
      << "it is the one that runs";
}

TEST_F(UpdateTrial, ThatIsKeptIsKeptAlsoWhereItsNoteCannotBeForgotten) {
  BeginTry(choice_, notes_, kVersion);
  choice_.SwitchOn();
  notes_.fault = std::errc::read_only_file_system;
  EXPECT_TRUE(ConfirmTried(choice_, notes_));
  EXPECT_EQ(choice_.SwitchOn(), Slot::kB);
  notes_.fault.reset();
  EXPECT_EQ(AfterStart(choice_, notes_).message, Message::kNothingWaits);
  EXPECT_EQ(notes_.pending, std::nullopt);
}

// Between loader.conf and the note.
TEST(LastingFaultTest, IsNotOneThatComesAndGoes) {
  const Time began = Time{} + seconds(1000);
  LastingFault fault;
  for (int s = 0; s < 60; ++s) EXPECT_FALSE(fault.Lasts(s % 9 != 0, began + seconds(s))) << s;
  EXPECT_FALSE(fault.Lasts(false, began + seconds(60)));
  EXPECT_FALSE(fault.Lasts(true, began + seconds(61)));
  EXPECT_FALSE(fault.Lasts(true, began + seconds(70)));
  EXPECT_TRUE(fault.Lasts(true, began + seconds(71)));
}

TEST_F(UpdateTrial, WhoseNoteOutlivesItsConfirmationIsOver) {
  BeginTry(choice_, notes_, kVersion);
  choice_.SwitchOn();
  ASSERT_TRUE(choice_.Confirm(Slot::kB));
  choice_.SwitchOn();
  EXPECT_EQ(AfterStart(choice_, notes_).message, Message::kNothingWaits);
  EXPECT_EQ(notes_.pending, std::nullopt);
}

TEST(UpdateConfirmation, WantsAMinuteOnEndWithoutAFault) {
  const Time began = ManualClock().now();
  Confirmation confirmation(began);
  EXPECT_EQ(confirmation.Observe({}, began), Verdict::kLooking);
  EXPECT_EQ(confirmation.Observe({}, began + seconds(59)), Verdict::kLooking);
  EXPECT_EQ(confirmation.Observe({"no picture", "画面なし"}, began + seconds(60)), Verdict::kLooking);
  EXPECT_EQ(confirmation.Observe({}, began + seconds(65)), Verdict::kLooking);
  EXPECT_EQ(confirmation.Observe({}, began + seconds(124)), Verdict::kLooking);
  EXPECT_EQ(confirmation.Observe({}, began + seconds(125)), Verdict::kStays);
  EXPECT_EQ(confirmation.Observe({"too late", "遅すぎ"}, began + seconds(500)), Verdict::kStays);
}

TEST(UpdateConfirmation, GivesWayAfterThreeMinutesWithItsLastFault) {
  const Time began = ManualClock().now();
  Confirmation confirmation(began);
  for (int at = 0; at < 180; at += 5)
    EXPECT_EQ(
        confirmation.Observe(at % 50 == 0 ? Reason{"it flickers", "点滅"} : Reason{}, began + seconds(at)),
        Verdict::kLooking)
        << at;
  EXPECT_EQ(confirmation.Observe({}, began + seconds(180)), Verdict::kGivesWay);
  EXPECT_EQ(confirmation.reason(), (Reason{"it flickers", "点滅"}));
}

TEST(UpdateRunning, IsReadFromTheRootAndFromTheFirstProgram) {
  const sim::TempFolder folder;
  const auto write = [&](const char* name, const std::string& text) {
    std::string file = folder.path() + "/" + name;
    EXPECT_TRUE(WriteWholeFile(file, {AsBytes(text)}));
    return file;
  };
  const auto version = write("version", "version 12\nleast 10\n");
  const auto running = ReadRunning(version, write("slot", "B"));
  ASSERT_TRUE(running);
  EXPECT_EQ(running->version, 12U);
  EXPECT_EQ(running->least, 10U);
  EXPECT_EQ(running->slot, Slot::kB);
  EXPECT_EQ(running->product, kProduct) << "a PC's root names none";
  const auto board = write("board", "version 12\nleast 10\nproduct kaori-box-rpi4-1\n");
  EXPECT_EQ(ReadRunning(board, write("slot", "B"))->product, "kaori-box-rpi4-1");
  EXPECT_FALSE(ReadRunning(version, write("slot", "")));
  EXPECT_FALSE(ReadRunning(write("other", "version 12"), write("slot", "A")));
}

}  // namespace
}  // namespace kaori::update
