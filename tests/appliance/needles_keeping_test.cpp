// What the needles keep: the journal and the folder of own expressions, and disks that are full or torn.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <random>
#include <sstream>

#include "appliance/needles/scribe.h"
#include "tests/appliance/board_file.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::testing {
namespace {

using needles::Change;
using needles::Journal;
using needles::News;
using needles::Work;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::uint64_t kCast = 77;  // Some fingerprint.

// While it lives, no file of this process grows beyond `bytes`: what a full disk is to a writer.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  void (*signal_)(int);
  rlimit before_{};
};

class NeedleKeeping : public ::testing::Test {
 protected:
  Work Some(const std::string& name, int place, unsigned seed = 1) const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> part(-0.02F, 0.02F);
    Work work{.lids = {0.25F, 0.5F}, .name = name, .place = place};
    for (std::size_t i = 0; i < points_.size(); ++i)
      work.pulls_m.push_back({part(random), part(random), part(random)});
    return work;
  }

  std::filesystem::path journal() const { return folder_.folder() / "needles.journal"; }
  std::filesystem::path own() const { return folder_.folder() / "own"; }
  Journal::Opened Open(std::uint64_t cast = kCast) const {
    return std::move(Journal::Open(journal(), cast).value());
  }
  void Append(const std::vector<needles::Record>& records) const {
    auto opened = Open();
    std::vector<std::uint8_t> bytes;
    for (const auto& record : records) needles::Encode(record, bytes);
    ASSERT_TRUE(opened.journal.Append(bytes));
  }
  void Put(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(own());
    std::ofstream(own() / name) << text;
  }
  std::vector<std::string> FilesOf(const std::filesystem::path& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
  }
  needles::Stored Read() const { return needles::ReadStore(own(), points_, cast_); }

  board::BoardFile folder_;
  face::Cast cast_ = MakeSyntheticCast({.columns = 16, .rows = 12});
  needles::Points points_ = needles::PointsOf(cast_.net);
};

TEST_F(NeedleKeeping, AJournalGivesBackWhatWasWrittenIntoIt) {
  Append({{Change::kBegun, Some("", -1)}, {Change::kPushed, Some("a", 3, 2)}});
  Append({{Change::kUndone, {}}});
  const auto opened = Open();
  ASSERT_EQ(opened.records.size(), 3U);
  EXPECT_EQ(opened.records[1].work, Some("a", 3, 2));
  EXPECT_EQ(opened.records[2].change, Change::kUndone);
  EXPECT_EQ(opened.torn_bytes, 0U);
}

TEST_F(NeedleKeeping, ATornJournalKeepsEveryWholeRecord) {
  Append({{Change::kBegun, Some("", -1)},
          {Change::kPushed, Some("a", 1, 2)},
          {Change::kPushed, Some("a", 1, 3)}});
  const auto whole = std::filesystem::file_size(journal());
  for (std::uintmax_t cut = 1; cut < 240; cut += 7) {
    std::filesystem::copy_file(journal(), folder_.folder() / "copy");
    std::filesystem::resize_file(folder_.folder() / "copy", whole - cut);
    auto opened = std::move(Journal::Open(folder_.folder() / "copy", kCast).value());
    ASSERT_EQ(opened.records.size(), 2U) << cut;
    ASSERT_EQ(opened.records[1].work, Some("a", 1, 2));
    EXPECT_GT(opened.torn_bytes, 0U);
    std::vector<std::uint8_t> more;
    needles::Encode({Change::kRedone, {}}, more);
    ASSERT_TRUE(opened.journal.Append(more)) << "and goes on behind them";
    { const auto closed = std::move(opened); }
    const auto again = std::move(Journal::Open(folder_.folder() / "copy", kCast).value());
    EXPECT_EQ(again.records.back().change, Change::kRedone);
    EXPECT_EQ(again.torn_bytes, 0U);
    std::filesystem::remove(folder_.folder() / "copy");
  }
}

TEST_F(NeedleKeeping, AJournalWithAFlippedBitEndsBeforeIt) {
  Append({{Change::kBegun, Some("", -1)}, {Change::kPushed, Some("a", 1, 2)}});
  std::fstream file(journal(), std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(-40, std::ios::end);
  file.put('\x5A');
  file.close();
  EXPECT_EQ(Open().records.size(), 1U);
}

TEST_F(NeedleKeeping, AJournalOfAnotherCastIsKeptAside) {
  Append({{Change::kBegun, Some("", -1)}});
  const auto opened = Open(kCast + 1);
  EXPECT_TRUE(opened.put_aside);
  EXPECT_THAT(opened.records, IsEmpty());
  EXPECT_TRUE(std::filesystem::exists(journal().string() + ".aside"));
}

TEST_F(NeedleKeeping, AJournalIsHeldByOneProgram) {
  const auto opened = Open();
  const auto second = Journal::Open(journal(), kCast);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().cause, std::errc::device_or_resource_busy);
}

TEST_F(NeedleKeeping, AFullDiskLeavesTheJournalAsItWasAndTakesItLater) {
  Append({{Change::kBegun, Some("", -1)}});
  const auto size = std::filesystem::file_size(journal());
  auto opened = Open();
  std::vector<std::uint8_t> bytes;
  needles::Encode({Change::kPushed, Some("a", 1, 2)}, bytes);
  {
    const SmallDisk full(size + 20);
    EXPECT_FALSE(opened.journal.Append(bytes));
    EXPECT_EQ(std::filesystem::file_size(journal()), size);
  }
  EXPECT_TRUE(opened.journal.Append(bytes));
  { const auto closed = std::move(opened); }
  EXPECT_EQ(Open().records.size(), 2U);
}

TEST_F(NeedleKeeping, AnOwnExpressionIsReadAsItWasWritten) {
  const Work written = Some("my_smile", 2);
  ASSERT_TRUE(needles::WriteToStore(own(), written, points_));
  EXPECT_THAT(FilesOf(own()), ElementsAre("03-my_smile.toml"));
  const auto read = Read().places[2];
  ASSERT_TRUE(read);
  EXPECT_EQ(read->name, "my_smile");
  EXPECT_EQ(read->place, 2);
  EXPECT_EQ(read->lids, written.lids);
  for (std::size_t i = 0; i < points_.size(); ++i)
    for (int part = 0; part < 3; ++part)
      EXPECT_NEAR(read->pulls_m[i][part], written.pulls_m[i][part], 0.6e-6F) << points_.names[i];
}

TEST_F(NeedleKeeping, AnOwnExpressionSaysOnceWhatIsAlikeOnBothSides) {
  Work work{.pulls_m = std::vector<glm::vec3>(points_.size()), .name = "plain", .place = 0};
  work.pulls_m[PointNamed(cast_, "MC.l")] = {0.005F, 0.001F, 0};
  work.pulls_m[PointNamed(cast_, "MC.r")] = {-0.005F, 0.001F, 0};
  work.pulls_m[PointNamed(cast_, "K.r")] = {-0.002F, 0, 0};
  work.pulls_m[PointNamed(cast_, "UC")] = {0, 0.003F, 0};
  const std::string text = needles::WriteOwn(work, points_);
  EXPECT_THAT(text, HasSubstr("[expression.both]\nUC = [0, 0.3, 0]\nMC = [0.5, 0.1, 0]\n"));
  EXPECT_THAT(text, HasSubstr("[expression.right]\nK = [0.2, 0, 0]\n"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("lids")));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("CH")));
}

TEST_F(NeedleKeeping, SavingUnderAnotherNameLeavesOneFileForAPlace) {
  ASSERT_TRUE(needles::WriteToStore(own(), Some("one", 0), points_));
  ASSERT_TRUE(needles::WriteToStore(own(), Some("two", 1), points_));
  ASSERT_TRUE(needles::WriteToStore(own(), Some("other", 0), points_));
  EXPECT_THAT(FilesOf(own()), ElementsAre("01-other.toml", "02-two.toml"));
  ASSERT_TRUE(needles::RemoveFromStore(own(), 1));
  EXPECT_THAT(FilesOf(own()), ElementsAre("01-other.toml"));
}

TEST_F(NeedleKeeping, AFaultyFileIsNamedAndKeptAsideAndTheRestIsRead) {
  ASSERT_TRUE(needles::WriteToStore(own(), Some("good", 4), points_));
  Put("01-broken.toml", "[[expression]]\nname = \"broken\"\nboth = { MC = [1, 2 }\n");
  Put("02-foreign.toml", "[[expression]]\nname = \"foreign\"\n[expression.both]\nXX = [0.1, 0, 0]\n");
  Put("03-far.toml", "[[expression]]\nname = \"far\"\n[expression.both]\nMC = [50, 0, 0]\n");
  Put("04-nameless.toml", "[[expression]]\nlids = [0, 0]\n");
  Put("06-twice.toml", "[[expression]]\nname = \"good\"\n");
  Put("07-lids.toml", "[[expression]]\nname = \"lids\"\nlids = [0, nan]\n");
  Put("notes.txt", "not ours");
  const auto stored = Read();
  EXPECT_TRUE(stored.places[4]);
  EXPECT_EQ(std::ranges::count_if(stored.places, [](const auto& own) { return own.has_value(); }), 1);
  EXPECT_THAT(
      stored.complaints,
      ElementsAre(HasSubstr("01-broken.toml:3"), HasSubstr("02-foreign.toml:4: XX: is no control point"),
                  HasSubstr("03-far.toml:4: MC"), HasSubstr("04-nameless.toml: it has no name"),
                  HasSubstr("06-twice.toml: another one is named \"good\""), HasSubstr("07-lids.toml:3")));
  EXPECT_THAT(FilesOf(own()), ElementsAre("01-broken.toml.faulty", "02-foreign.toml.faulty",
                                          "03-far.toml.faulty", "04-nameless.toml.faulty", "05-good.toml",
                                          "06-twice.toml.faulty", "07-lids.toml.faulty", "notes.txt"));
  EXPECT_THAT(Read().complaints, IsEmpty()) << "they are named once";
}

class NeedleScribe : public NeedleKeeping {
 protected:
  std::unique_ptr<needles::Scribe> Begin() {
    return std::make_unique<needles::Scribe>(std::move(Open().journal), own(), points_);
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
  EXPECT_THAT(KindsOf(scribe->TakeNews()), ElementsAre(News::Kind::kSaved));
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
    const auto news = scribe->TakeNews();
    EXPECT_THAT(KindsOf(news), ElementsAre(News::Kind::kFailing)) << "said once";
    EXPECT_THAT(news[0].text, HasSubstr("too large"));
    EXPECT_FALSE(Read().places[0]);
  }
  scribe->Finish();
  EXPECT_THAT(KindsOf(scribe->TakeNews()), ElementsAre(News::Kind::kSaved, News::Kind::kWorking));
  scribe.reset();
  EXPECT_EQ(Open().records.size(), 6U);
  EXPECT_TRUE(Read().places[0]);
}

}  // namespace
}  // namespace kaori::testing
