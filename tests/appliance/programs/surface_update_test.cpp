// Updates from the box's side: to a surface whose firmware is the real one, on a flash whose power can be cut at any operation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/appliance/core/board_file.h"
#include "tests/appliance/programs/surface_box.h"
#include "tests/firmware/figures.h"

namespace kaori::surface_update {
namespace {

using proof::Cut;
using std::chrono::milliseconds;
using ::testing::HasSubstr;

// Until it has an outcome, or two minutes are over.
void RunToItsEnd(SurfaceUpdate& update, Box& box) {
  using State = SurfaceUpdate::State;
  for (int n = 0; n < 6000 && update.state() != State::kDone && update.state() != State::kFailed; ++n) {
    update.Step(box.now);
    box.Play(milliseconds(20));
  }
}

TEST(SurfaceUpdate, ANewImageIsTriedForTenSecondsAndThenKept) {
  Box box;
  const UpdateFile file = MakeUpdate(kVersion2);
  SurfaceUpdate update(box, "1-4.1", file);
  while (update.state() != SurfaceUpdate::State::kTrying) {
    update.Step(box.now);
    box.Play(milliseconds(20));
    ASSERT_NE(update.state(), SurfaceUpdate::State::kFailed) << update.outcome();
  }
  const Time since = box.now;
  EXPECT_FALSE(surface::IsKept(box.flash, surface::Slot::kB));
  RunToItsEnd(update, box);
  EXPECT_EQ(update.outcome(), "the surface at 1-4.1 plays version 2.0");
  EXPECT_GE(box.now - since, SurfaceUpdate::kProbation);
  EXPECT_TRUE(surface::IsKept(box.flash, surface::Slot::kB));
  SurfaceUpdate again(box, "1-4.1", file);
  RunToItsEnd(again, box);
  EXPECT_EQ(again.outcome(), "the surface at 1-4.1 has version 2.0 already");
}

TEST(SurfaceUpdate, AnImageThatDoesNotStartOrDiesEarlyIsGivenUpAndTheOneBeforePlays) {
  for (const Duration dies_after :
       {Duration(0), Duration(milliseconds(50)), Duration(std::chrono::seconds(6))}) {
    Box box;
    box.deadly_version = kVersion2;
    box.deadly_after = dies_after;
    const UpdateFile file = MakeUpdate(kVersion2);
    SurfaceUpdate update(box, "1-4.1", file);
    RunToItsEnd(update, box);
    EXPECT_EQ(update.state(), SurfaceUpdate::State::kFailed);
    EXPECT_THAT(update.outcome(), HasSubstr("the new image did not start; it plays version 1.0 as before"));
    EXPECT_EQ(box.version, kVersion1);
  }
}

TEST(SurfaceUpdate, AnImageThatIsNeverConfirmedIsSaidAndTheOneBeforePlaysAgain) {
  Box box;
  box.confirms = false;
  const UpdateFile file = MakeUpdate(kVersion2);
  SurfaceUpdate update(box, "1-4.1", file);
  RunToItsEnd(update, box);
  EXPECT_EQ(update.outcome(), "the surface at 1-4.1 was not updated: it does not confirm the new image");
  for (int starts = 0; starts < 3; ++starts) box.PowerOn();
  EXPECT_EQ(box.version, kVersion1);
}

TEST(SurfaceUpdate, AnImageThatFindsItsChipTooOldIsNotConfirmedAndTheOneBeforePlaysAgain) {
  Box box;
  box.refusing_version = kVersion2;
  const UpdateFile file = MakeUpdate(kVersion2);
  SurfaceUpdate update(box, "1-4.1", file);
  RunToItsEnd(update, box);
  EXPECT_THAT(update.outcome(),
              HasSubstr("with the new image it refuses to play: its chip is an RP2040 B1, and "
                        "only B2 and later ones may be used"));
  EXPECT_FALSE(surface::IsKept(box.flash, surface::Slot::kB));
  for (int starts = 0; starts < 3; ++starts) box.PowerOn();
  EXPECT_EQ(box.version, kVersion1);
}

TEST(SurfaceUpdate, ASurfaceThatRefusesIsGivenNothingAndCountsForNoDialBox) {
  Box box;
  box.refusing_version = kVersion1;
  const auto operations = box.flash.operations();
  const UpdateFile file = MakeUpdate(kVersion2);
  SurfaceUpdate update(box, "1-4.1", file);
  RunToItsEnd(update, box);
  EXPECT_THAT(update.outcome(), HasSubstr("was not updated: it refuses to play: its chip is an RP2040 B1"));
  EXPECT_EQ(box.flash.operations(), operations);
  const auto channel = box.Open("1-4.1");
  EXPECT_FALSE(IsPlayingDialBox((*channel)->identity(), ReadStatus(**channel)));
  box.refusing_version = 0;
  EXPECT_TRUE(IsPlayingDialBox((*channel)->identity(), ReadStatus(**channel)));
}

TEST(SurfaceUpdate, AnImageOfAnotherProductIsRefusedAndChangesNothing) {
  Box box;
  const UpdateFile file = MakeUpdate(kVersion2, 0x12090002);
  const auto operations = box.flash.operations();
  SurfaceUpdate update(box, "1-4.1", file);
  RunToItsEnd(update, box);
  EXPECT_THAT(update.outcome(), HasSubstr("was not updated: it refuses the image"));
  EXPECT_EQ(box.flash.operations(), operations);
}

TEST(SurfaceUpdate, ASurfaceThatIsNotThereIsSaidAfterAWhile) {
  Box box;
  box.PowerOff(std::chrono::hours(1));
  const UpdateFile file = MakeUpdate(kVersion2);
  SurfaceUpdate update(box, "1-4.1", file);
  RunToItsEnd(update, box);
  EXPECT_EQ(update.outcome(), "the surface at 1-4.1 was not updated: it is not there");
}

TEST(SurfaceUpdate, ACutOfThePowerAtAnyOperationLeavesASurfaceThatPlaysAndTheUpdateGoesOn) {
  const UpdateFile file = MakeUpdate(kVersion2);
  std::uint32_t cuts = 0;
  std::uint32_t dead = 0;
  for (const Cut how : {Cut::kBefore, Cut::kHalf, Cut::kAfter}) {
    for (std::uint32_t operation = 1;; ++operation) {
      Box box;
      box.flash.CutAt(operation, how, operation * 31 + static_cast<std::uint32_t>(how));
      SurfaceUpdate update(box, "1-4.1", file);
      RunToItsEnd(update, box);
      ++cuts;
      if (::testing::Test::HasFatalFailure()) return;
      // Whatever became of this one, the next finds a surface that plays, and succeeds.
      box.PowerOn();
      SurfaceUpdate next(box, "1-4.1", file);
      RunToItsEnd(next, box);
      dead += next.state() == SurfaceUpdate::State::kDone && box.version == kVersion2 ? 0U : 1U;
      EXPECT_EQ(next.state(), SurfaceUpdate::State::kDone) << operation << ": " << next.outcome();
      EXPECT_EQ(update.state(), SurfaceUpdate::State::kDone) << operation << ": " << update.outcome();
      if (operation > box.flash.operations()) break;
    }
  }
  EXPECT_GT(cuts, 50U);
  proof::Figure("box_update_cuts", cuts);
  proof::Figure("box_update_cuts_dead", dead);
}

TEST(SurfaceUpdate, OnlyInServiceAndNeverTheLastDialBoxOfARunningShow) {
  const wire::SurfaceImage box{.product = kBoxProduct}, stick{.product = 0x12090002};
  EXPECT_THAT(MayUpdate(box, {.in_service = false}).error().message(), HasSubstr("in service only"));
  const Circumstances running{.in_service = true, .show_runs = true, .dial_boxes = 1};
  EXPECT_THAT(MayUpdate(box, running).error().message(), HasSubstr("the last dial box of a running show"));
  EXPECT_TRUE(MayUpdate(stick, running));
  EXPECT_TRUE(MayUpdate(box, {.in_service = true, .show_runs = true, .dial_boxes = 2}));
  EXPECT_TRUE(MayUpdate(box, {.in_service = true, .show_runs = false, .dial_boxes = 1}));
}

TEST(UpdateFile, IsReadWholeOrNotAtAll) {
  board::BoardFile folder;
  const UpdateFile made = MakeUpdate(kVersion2);
  const auto path = folder.folder() / "box.update";
  const auto write = [&](std::size_t cut) {
    std::ofstream out(path, std::ios::binary);
    for (const std::uint8_t byte : wire::Encode(made.image)) out.put(static_cast<char>(byte));
    for (std::size_t n = 0; n + cut < made.bytes.size(); ++n) out.put(static_cast<char>(made.bytes[n]));
  };
  write(0);
  EXPECT_EQ(ReadUpdateFile(path)->image, made.image);
  EXPECT_EQ(ReadUpdateFile(path)->bytes, made.bytes);
  write(1);
  EXPECT_THAT(ReadUpdateFile(path).error().message(),
              HasSubstr("its image has 2999 bytes where its head says 3000"));
  write(3000);
  EXPECT_THAT(ReadUpdateFile(path).error().message(), HasSubstr("too short"));
}

}  // namespace
}  // namespace kaori::surface_update
