// What the handles keep: the journal and the folder of own expressions, and disks that are full or torn.
#include "tests/appliance/programs/editor_saving_fixture.h"

namespace kaori::tests {
namespace {

TEST_F(HandleKeeping, AJournalGivesBackWhatWasWrittenIntoIt) {
  Append({{Change::kBegun, Some("", -1)}, {Change::kPushed, Some("a", 3, 2)}});
  Append({{Change::kUndone, {}}});
  const auto opened = Open();
  ASSERT_EQ(opened.records.size(), 3U);
  EXPECT_EQ(opened.records[1].work, Some("a", 3, 2));
  EXPECT_EQ(opened.records[2].change, Change::kUndone);
  EXPECT_EQ(opened.torn_bytes, 0U);
}

TEST_F(HandleKeeping, ATornJournalKeepsEveryWholeRecord) {
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
    editor::Encode({Change::kRedone, {}}, more);
    ASSERT_TRUE(opened.journal.Append(more)) << "and goes on behind them";
    { const auto closed = std::move(opened); }
    const auto again = std::move(Journal::Open(folder_.folder() / "copy", kCast).value());
    EXPECT_EQ(again.records.back().change, Change::kRedone);
    EXPECT_EQ(again.torn_bytes, 0U);
    std::filesystem::remove(folder_.folder() / "copy");
  }
}

TEST_F(HandleKeeping, AJournalWithAFlippedBitEndsBeforeIt) {
  Append({{Change::kBegun, Some("", -1)}, {Change::kPushed, Some("a", 1, 2)}});
  std::fstream file(journal(), std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(-40, std::ios::end);
  file.put('\x5A');
  file.close();
  EXPECT_EQ(Open().records.size(), 1U);
}

TEST_F(HandleKeeping, NoDamageToAJournalOrAFileIsMoreThanALoss) {
  std::vector<std::uint8_t> journal;
  for (unsigned i = 0; i < 4; ++i) editor::Encode({Change::kPushed, Some("a", 1, i)}, journal);
  const std::string text = editor::WriteOwn(Some("a", 1), points_);
  std::mt19937 random(9);
  for (int i = 0; i < 2000; ++i) {
    auto bytes = journal;
    for (unsigned k = 0; k <= random() % 4; ++k)
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    bytes.resize(random() % (bytes.size() + 1));
    const auto decoded = editor::Decode(bytes);
    ASSERT_LE(decoded.sound_bytes, bytes.size());
    for (const auto& record : decoded.records) ASSERT_EQ(record.work.pulls_m.size(), points_.size());
    std::string damaged = text;
    for (unsigned k = 0; k <= random() % 3; ++k)
      damaged[random() % damaged.size()] = static_cast<char>(random());
    const auto read = editor::ReadOwn(damaged, "file", points_, cast_);
    ASSERT_TRUE(!read || editor::Session(points_).Replace(*read) == Change::kAdopted) << damaged;
  }
}

TEST_F(HandleKeeping, AJournalOfAnotherCastIsKeptAsideUntilThatCastPlaysAgain) {
  Append({{Change::kBegun, Some("", -1, 3)}});
  for (int turn = 0; turn < 2; ++turn) {
    auto other = Open(kCast + 1);
    EXPECT_TRUE(other.put_aside);
    EXPECT_EQ(other.records.size(), static_cast<std::size_t>(turn));
    std::vector<std::uint8_t> bytes;
    if (turn == 0) editor::Encode({Change::kBegun, Some("", -1, 4)}, bytes);
    ASSERT_TRUE(other.journal.Append(bytes));
    { const auto closed = std::move(other); }
    const auto again = Open();
    ASSERT_EQ(again.records.size(), 1U);
    EXPECT_EQ(again.records[0].work, Some("", -1, 3));
  }
}

TEST_F(HandleKeeping, AJournalIsHeldByOneProgram) {
  const auto opened = Open();
  const auto second = Journal::Open(journal(), kCast);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().cause, std::errc::device_or_resource_busy);
}

TEST_F(HandleKeeping, AFullDiskLeavesTheJournalAsItWasAndTakesItLater) {
  Append({{Change::kBegun, Some("", -1)}});
  const auto size = std::filesystem::file_size(journal());
  auto opened = Open();
  std::vector<std::uint8_t> bytes;
  editor::Encode({Change::kPushed, Some("a", 1, 2)}, bytes);
  {
    const SmallDisk full(size + 20);
    EXPECT_FALSE(opened.journal.Append(bytes));
    EXPECT_EQ(std::filesystem::file_size(journal()), size);
  }
  EXPECT_TRUE(opened.journal.Append(bytes));
  { const auto closed = std::move(opened); }
  EXPECT_EQ(Open().records.size(), 2U);
}

TEST_F(HandleKeeping, AnOwnExpressionIsReadAsItWasWritten) {
  const Work written = Some("my_smile", 2);
  ASSERT_TRUE(editor::WriteToStore(own(), written, points_));
  EXPECT_THAT(FilesOf(own()), ElementsAre("03-my_smile.toml"));
  const auto read = Read().slots[2];
  ASSERT_TRUE(read);
  EXPECT_EQ(read->name, "my_smile");
  EXPECT_EQ(read->slot, 2);
  EXPECT_EQ(read->lids, written.lids);
  for (std::size_t i = 0; i < points_.size(); ++i)
    for (int part = 0; part < 3; ++part)
      EXPECT_NEAR(read->pulls_m[i][part], written.pulls_m[i][part], 0.6e-6F) << points_.names[i];
}

TEST_F(HandleKeeping, AnOwnExpressionSaysOnceWhatIsAlikeOnBothSides) {
  Work work{.pulls_m = std::vector<glm::vec3>(points_.size()), .name = "plain", .slot = 0};
  work.pulls_m[PointNamed(cast_, "MC.l")] = {0.005F, 0.001F, 0};
  work.pulls_m[PointNamed(cast_, "MC.r")] = {-0.005F, 0.001F, 0};
  work.pulls_m[PointNamed(cast_, "K.r")] = {-0.002F, 0, 0};
  work.pulls_m[PointNamed(cast_, "UC")] = {0, 0.003F, 0};
  const std::string text = editor::WriteOwn(work, points_);
  EXPECT_THAT(text, HasSubstr("[expression.both]\nUC = [0, 0.3, 0]\nMC = [0.5, 0.1, 0]\n"));
  EXPECT_THAT(text, HasSubstr("[expression.right]\nK = [0.2, 0, 0]\n"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("lids")));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("CH")));
}

TEST_F(HandleKeeping, SavingUnderAnotherNameLeavesOneFileForAPlace) {
  ASSERT_TRUE(editor::WriteToStore(own(), Some("one", 0), points_));
  ASSERT_TRUE(editor::WriteToStore(own(), Some("two", 1), points_));
  ASSERT_TRUE(editor::WriteToStore(own(), Some("other", 0), points_));
  EXPECT_THAT(FilesOf(own()), ElementsAre("01-other.toml", "02-two.toml"));
  ASSERT_TRUE(editor::RemoveFromStore(own(), 1));
  EXPECT_THAT(FilesOf(own()), ElementsAre("01-other.toml"));
}

TEST_F(HandleKeeping, AFaultyFileIsNamedAndKeptAsideAndTheRestIsRead) {
  ASSERT_TRUE(editor::WriteToStore(own(), Some("good", 4), points_));
  Put("01-broken.toml", "[[expression]]\nname = \"broken\"\nboth = { MC = [1, 2 }\n");
  Put("02-foreign.toml", "[[expression]]\nname = \"foreign\"\n[expression.both]\nXX = [0.1, 0, 0]\n");
  Put("03-far.toml", "[[expression]]\nname = \"far\"\n[expression.both]\nMC = [50, 0, 0]\n");
  Put("04-nameless.toml", "[[expression]]\nlids = [0, 0]\n");
  Put("06-twice.toml", "[[expression]]\nname = \"good\"\n");
  Put("07-lids.toml", "[[expression]]\nname = \"lids\"\nlids = [0, nan]\n");
  Put("notes.txt", "not ours");
  const auto stored = Read();
  EXPECT_TRUE(stored.slots[4]);
  EXPECT_EQ(std::ranges::count_if(stored.slots, [](const auto& own) { return own.has_value(); }), 1);
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

TEST_F(HandleKeeping, AFileOfAnotherShowComesBackWithIts) {
  ASSERT_TRUE(editor::WriteToStore(own(), Some("mine", 2), points_));
  editor::Points others = points_;
  for (std::string& name : others.names) name.insert(0, "X");
  EXPECT_FALSE(editor::ReadStore(own(), others, cast_).slots[2]);
  Work theirs = Some("mine", 2, 5);
  ASSERT_TRUE(editor::WriteToStore(own(), theirs, others));
  const auto mine = Read().slots[2];
  ASSERT_TRUE(mine) << "though the other show has one of the same name and place";
  EXPECT_NEAR(mine->pulls_m[0].x, Some("mine", 2).pulls_m[0].x, 0.6e-6F);
  const auto again = editor::ReadStore(own(), others, cast_).slots[2];
  ASSERT_TRUE(again);
  EXPECT_NEAR(again->pulls_m[0].x, theirs.pulls_m[0].x, 0.6e-6F);
}

TEST_F(HandleKeeping, AFaultyFileThatIsMendedComesBackToItsFreePlaceOnly) {
  Put("01-a.toml", "[[expression]]\nname = \"a\"\nlids = [0, 9]\n");
  EXPECT_FALSE(Read().slots[0]);
  Put("01-a.toml.faulty", "[[expression]]\nname = \"a\"\nlids = [0, 0.5]\n");
  EXPECT_TRUE(Read().slots[0]);
  EXPECT_THAT(FilesOf(own()), ElementsAre("01-a.toml"));
  Put("01-b.toml.faulty", "[[expression]]\nname = \"b\"\n");
  EXPECT_EQ(Read().slots[0]->name, "a");
  EXPECT_THAT(FilesOf(own()), ElementsAre("01-a.toml", "01-b.toml.faulty"));
}

}  // namespace
}  // namespace kaori::tests
