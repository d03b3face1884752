// The thread that writes: what it keeps, in which order, and what it does on a full disk.
#include "tests/appliance/programs/editor_keeping_fixture.h"

namespace kaori::testing {
namespace {

class NeedleScribe : public NeedleKeeping {
 protected:
  std::unique_ptr<editor::Scribe> Begin() {
    return std::make_unique<editor::Scribe>(std::move(Open().journal), own(), points_);
  }
  std::vector<News::Kind> KindsOf(const std::vector<News>& news) const {
    std::vector<News::Kind> kinds;
    for (const News& item : news) kinds.push_back(item.kind);
    return kinds;
  }
};

TEST_F(NeedleScribe, WritesTheJournalAndTheFiles) {
  auto scribe = Begin();
  scribe->Note(Change::kBegun, Some("", -1));
  scribe->Note(Change::kPushed, Some("a", 0, 2));
  scribe->Save(Some("a", 0, 2));
  scribe->Finish();
  ASSERT_TRUE(scribe->has_news());
  EXPECT_THAT(KindsOf(scribe->DrainNews()), ElementsAre(News::Kind::kSaved));
  EXPECT_FALSE(scribe->has_news());
  scribe.reset();
  EXPECT_EQ(Open().records.size(), 2U);
  EXPECT_TRUE(Read().places[0]);
}

TEST_F(NeedleScribe, KeepsOneRecordOfAGestureThatGoesOn) {
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

TEST_F(NeedleScribe, ForgetsWhatWasBeforeANewBeginning) {
  auto scribe = Begin();
  for (unsigned i = 0; i < 50; ++i) scribe->Note(Change::kPushed, Some("", -1, i));
  scribe->Note(Change::kBegun, Some("", -1, 99));
  scribe.reset();
  const auto records = Open().records;
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].work, Some("", -1, 99));
}

TEST_F(NeedleScribe, WorksInMemoryOnAFullDiskAndWritesAllWhenThereIsRoom) {
  auto scribe = Begin();
  scribe->Note(Change::kBegun, Some("", -1));
  scribe->Finish();
  {
    const SmallDisk full(std::filesystem::file_size(journal()));
    for (unsigned i = 0; i < 5; ++i) scribe->Note(Change::kPushed, Some("a", 0, i));
    scribe->Save(Some("a", 0, 4));
    scribe->Finish();
    scribe->Finish();
    const auto news = scribe->DrainNews();
    EXPECT_THAT(KindsOf(news), ElementsAre(News::Kind::kFailing)) << "said once";
    EXPECT_THAT(news[0].text, HasSubstr("too large"));
    EXPECT_FALSE(Read().places[0]);
  }
  scribe->Finish();
  EXPECT_THAT(KindsOf(scribe->DrainNews()), ElementsAre(News::Kind::kSaved, News::Kind::kWorking));
  scribe.reset();
  EXPECT_EQ(Open().records.size(), 6U);
  EXPECT_TRUE(Read().places[0]);
}

}  // namespace
}  // namespace kaori::testing
