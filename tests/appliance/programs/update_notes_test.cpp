// What a box keeps of an update is there after a start, and has room on a full disk.
#include "appliance/programs/update/notes.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/hw-sim/link_fixture.h"

namespace kaori::update {
namespace {

using ports::Slot;

TEST(UpdateNotes, AreThereAfterAStartAndATextThatIsNoneIsNone) {
  const sim::TempFolder folder;
  const auto notes = OpenNotes(folder.path() + "/update");
  EXPECT_EQ(notes->ReadPending(), std::nullopt);
  ASSERT_TRUE(notes->KeepPending({12, Slot::kA, 2}));
  ASSERT_TRUE(notes->KeepLastTry("why\nits log"));
  const auto after = OpenNotes(folder.path() + "/update");
  EXPECT_EQ(after->ReadPending(), (Pending{12, Slot::kA, 2}));
  EXPECT_EQ(after->ReadLastTry(), "why\nits log");
  ASSERT_TRUE(after->ForgetPending());
  ASSERT_TRUE(after->KeepLastTry(""));
  EXPECT_EQ(notes->ReadPending(), std::nullopt);
  EXPECT_EQ(notes->ReadLastTry(), "");
  for (const char* text : {"", "12 A", "12 C 0\n", "x A 0\n", "12 A 0\nmore"})
    EXPECT_EQ(ParsePending(text), std::nullopt) << text;
}

TEST(UpdateNotes, OfASystemBeforeAreKeptBesideThoseOfTheUpdate) {
  const sim::TempFolder folder;
  const auto notes = OpenNotes(folder.path() + "/update");
  EXPECT_EQ(notes->ReadBefore(), std::nullopt);
  ASSERT_TRUE(notes->KeepBefore({11, Slot::kA, 0}));
  EXPECT_EQ(OpenNotes(folder.path() + "/update")->ReadBefore(), (Pending{11, Slot::kA, 0}));
  EXPECT_EQ(notes->ReadPending(), std::nullopt);
}

TEST(UpdateNotes, OfASystemThatIsOverwrittenTellItsVersionUntilThatHasEnded) {
  const sim::TempFolder folder;
  const auto notes = OpenNotes(folder.path() + "/update");
  ASSERT_TRUE(notes->BeginOverwriting()) << "of nothing";
  ASSERT_TRUE(notes->KeepBefore({11, Slot::kA, 0}));
  ASSERT_TRUE(notes->BeginOverwriting());
  ASSERT_TRUE(notes->BeginOverwriting()) << "an update that was broken off comes again";
  EXPECT_EQ(notes->ReadBefore(), std::nullopt);
  EXPECT_EQ(OpenNotes(folder.path() + "/update")->ReadOverwritten(), (Pending{11, Slot::kA, 0}));
  ASSERT_TRUE(notes->EndOverwriting());
  EXPECT_EQ(notes->ReadOverwritten(), std::nullopt);
}

TEST(UpdateNotes, HaveRoomReservedThatIsOfTheDisk) {
  const sim::TempFolder folder;
  const auto notes = OpenNotes(folder.path() + "/update");
  ASSERT_TRUE(notes->Reserve());
  struct stat status {};
  ASSERT_EQ(::stat((folder.path() + "/update/reserved").c_str(), &status), 0);
  EXPECT_GE(status.st_size, 160 << 10);
  EXPECT_GE(status.st_blocks * 512, 160 << 10) << "no hole";
  EXPECT_TRUE(notes->Reserve()) << "it is there";
}

}  // namespace
}  // namespace kaori::update
