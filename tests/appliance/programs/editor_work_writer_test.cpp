// The thread that writes: what it keeps, in which order, and what it does on a full disk.
#include "tests/appliance/programs/editor_saving_fixture.h"

namespace kaori::tests {
namespace {

class HandleScribe : public HandleKeeping {
 protected:
  std::unique_ptr<editor::WorkWriter> Begin() {
    return std::make_unique<editor::WorkWriter>(std::move(Open().journal), own(), points_);
  }
  std::vector<Outcome::Kind> KindsOf(const std::vector<Outcome>& news) const {
    std::vector<Outcome::Kind> kinds;
    for (const Outcome& item : news) kinds.push_back(item.kind);
    return kinds;
  }
};

TEST_F(HandleScribe, WritesTheJournalAndTheFiles) {
  auto scribe = Begin();
  scribe->Note(Change::kBegun, Some("", -1));
  scribe->Note(Change::kPushed, Some("a", 0, 2));
  scribe->Save(Some("a", 0, 2));
  scribe->Finish();
  ASSERT_TRUE(scribe->has_outcomes());
  EXPECT_THAT(KindsOf(scribe->DrainOutcomes()), ElementsAre(Outcome::Kind::kSaved));
  EXPECT_FALSE(scribe->has_outcomes());
  scribe.reset();
  EXPECT_EQ(Open().records.size(), 2U);
  EXPECT_TRUE(Read().slots[0]);
}

TEST_F(HandleScribe, KeepsOneRecordOfAGestureThatGoesOn) {
  auto scribe = Begin();
  scribe->Note(Change::kBegun, Some("", -1));
  scribe->Finish();
  scribe->Note(Change::kPushed, Some("", -1, 2));
  for (unsigned i = 0; i < 100; ++i) scribe->Note(Change::kReplaced, Some("", -1, 3 + i));
  scribe.reset();
  const auto records = Open().records;
  EXPECT_LE(records.size(), 3U);
  EXPECT_EQ(records.back().work, Some("", -1, 102));
}

TEST_F(HandleScribe, ForgetsWhatWasBeforeANewBeginning) {
  auto scribe = Begin();
  for (unsigned i = 0; i < 50; ++i) scribe->Note(Change::kPushed, Some("", -1, i));
  scribe->Note(Change::kBegun, Some("", -1, 99));
  scribe.reset();
  const auto records = Open().records;
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].work, Some("", -1, 99));
}

TEST_F(HandleScribe, WorksInMemoryOnAFullDiskAndWritesAllWhenThereIsRoom) {
  auto scribe = Begin();
  scribe->Note(Change::kBegun, Some("", -1));
  scribe->Finish();
  {
    const SmallDisk full(std::filesystem::file_size(journal()));
    for (unsigned i = 0; i < 5; ++i) scribe->Note(Change::kPushed, Some("a", 0, i));
    scribe->Save(Some("a", 0, 4));
    scribe->Finish();
    scribe->Finish();
    const auto news = scribe->DrainOutcomes();
    EXPECT_THAT(KindsOf(news), ElementsAre(Outcome::Kind::kFailing)) << "said once";
    EXPECT_THAT(news[0].text, HasSubstr("too large"));
    EXPECT_FALSE(Read().slots[0]);
  }
  scribe->Finish();
  EXPECT_THAT(KindsOf(scribe->DrainOutcomes()), ElementsAre(Outcome::Kind::kSaved, Outcome::Kind::kWorking));
  scribe.reset();
  EXPECT_EQ(Open().records.size(), 6U);
  EXPECT_TRUE(Read().slots[0]);
}

}  // namespace
}  // namespace kaori::tests
