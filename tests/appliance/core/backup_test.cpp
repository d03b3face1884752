// A backup of a data partition: what is in it, and every way in which one can be wrong.
#include <gmock/gmock.h>

#include "appliance/core/store/choice.h"
#include "tests/appliance/core/backup_fixture.h"

namespace kaori::backup {
namespace {

using ::testing::HasSubstr;

std::errc CauseOf(const Result<void>& read) {
  return read ? std::errc{} : read.error().cause;
}

TEST_F(BackupTest, HasWhatPeopleMadeAndNothingThatIdentifiesTheBox) {
  const auto text = Write();
  ASSERT_TRUE(text) << text.error().message();
  Collected read;
  ASSERT_TRUE(Read(std::make_unique<TextInput>(*text), read));
  EXPECT_EQ(read.files, (std::map<std::string, std::string>{{"lips/lips.settings", std::string(5000, 'l')},
                                                            {"own/01-smile.toml", "smile"},
                                                            {"own/log/2026-11-23", "a report"},
                                                            {"settings/box.toml", "profile = \"stage\"\n"},
                                                            {"settings/keys/company.pub", "a key"}}));
  EXPECT_EQ(read.whole, read.files.size());
}

TEST_F(BackupTest, HasTheChosenShowAndNoOther) {
  const std::string chosen(64, 'a'), other(64, 'b');
  Put("shows/" + store::PackName(chosen), std::string(3 << 20, 'p'));
  Put("shows/" + store::PackName(other), "another pack");
  Put("shows/choice.1", store::Format({1, chosen, std::string(store::kRootShow)}));
  Collected read;
  ASSERT_TRUE(Read(std::make_unique<TextInput>(Write().value()), read));
  EXPECT_EQ(read.files["shows/" + store::PackName(chosen)].size(), std::size_t{3} << 20U);
  EXPECT_FALSE(read.files.contains("shows/" + store::PackName(other)));
}

TEST_F(BackupTest, OfTheSameBoxIsTheSameBitForBit) {
  EXPECT_EQ(Write().value(), Write().value());
}

TEST_F(BackupTest, ThatEndsAnywhereIsRefused) {
  const std::string text = Write().value();
  for (std::size_t end = 0; end < text.size(); end += 37)
    EXPECT_FALSE(Read(text.substr(0, end))) << "it ends after " << end << " bytes";
  EXPECT_EQ(CauseOf(Read(text.substr(0, text.size() - 1))), kCutOffBackup);
  EXPECT_EQ(CauseOf(Read(text + "x")), kCutOffBackup);
}

TEST_F(BackupTest, WithAnyByteChangedIsRefusedOrTheSame) {
  const std::string text = Write().value();
  Collected good;
  ASSERT_TRUE(Read(std::make_unique<TextInput>(text), good));
  for (std::size_t at = 0; at < text.size(); at += 5) {
    std::string bad = text;
    bad[at] = static_cast<char>(bad[at] ^ 0x10);
    Collected read;
    if (Read(std::make_unique<TextInput>(bad), read)) {
      EXPECT_EQ(read.files, good.files) << "byte " << at;
    }
  }
}

TEST_F(BackupTest, OfANewerVersionSaysSo) {
  EXPECT_EQ(CauseOf(Read(OfList("kaori-backup 2\nanything else\n"))), kNewerBackup);
}

TEST_F(BackupTest, WithANameOutsideOfItsFoldersIsRefused) {
  for (const char* path :
       {"../machine-id", "machine-id", "own/../../etc/passwd", "/etc/passwd", "shows/choice.0"}) {
    Contents contents{"a box", "today", std::string(store::kRootShow), {{{path, 1}, std::string(64, 'a')}}};
    EXPECT_EQ(CauseOf(Read(OfList(Format(contents)))), kOutsideBackup) << path;
  }
}

TEST_F(BackupTest, ThatClaimsTooMuchIsRefusedBeforeItIsRead) {
  const std::string sum(64, 'a'), root(store::kRootShow);
  EXPECT_EQ(CauseOf(Read(OfList(Format({"", "", root, {{{"own/01-a.toml", kLargestFile_bytes + 1}, sum}}})))),
            std::errc::file_too_large);
  Contents many{"", "", root, {}};
  for (std::size_t n = 0; n <= kMostFiles; ++n)
    many.files.push_back({{"own/" + std::to_string(n) + ".toml", 1}, sum});
  EXPECT_EQ(CauseOf(Read(OfList(Format(many)))), std::errc::file_too_large);
  EXPECT_EQ(CauseOf(Read(OfList(std::string(kMostContents_bytes + 1, 'x')))), std::errc::file_too_large);
}

TEST_F(BackupTest, ThatNamesAFileTwiceOrAShowWithoutItsPackIsDamaged) {
  const std::string sum(64, 'a'), root(store::kRootShow);
  const Entry entry{{"own/01-a.toml", 1}, sum};
  EXPECT_EQ(CauseOf(Read(OfList(Format({"", "", root, {entry, entry}})))), std::errc::invalid_argument);
  EXPECT_EQ(CauseOf(Read(OfList(Format({"", "", sum, {entry}})))), std::errc::invalid_argument);
}

TEST_F(BackupTest, OfOtherThingsSaysThatItIsNone) {
  EXPECT_EQ(CauseOf(Read("")), kNoBackup);
  EXPECT_EQ(CauseOf(Read(std::string(4096, 'x'))), kNoBackup);
  EXPECT_EQ(CauseOf(Read(OfList("another list\n"))), kNoBackup);
}

TEST_F(BackupTest, FromAStickThatIsPulledIsNoFaultOfTheBackup) {
  Collected sink;
  const auto read = Read(std::make_unique<TextInput>(Write().value(), 3000), sink);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, ErrorKind::kSystem);
}

TEST_F(BackupTest, OfABoxThatChangesMeanwhileIsNotWritten) {
  auto writer = Writer::Begin(data_, {"a box", "today"}, file_);
  ASSERT_TRUE(writer);
  Result<bool> done = false;
  for (int n = 0; n < 6; ++n) done = writer->Step();  // All of the list's sums.
  Put("own/01-smile.toml", "grin!");
  while (done && !*done) done = writer->Step();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().cause, std::errc::text_file_busy);
}

// A stage that plays adds to its log each half minute.
TEST_F(BackupTest, HasAsMuchOfAGrowingReportAsThereWasAtFirst) {
  auto writer = Writer::Begin(data_, {"a box", "today"}, file_);
  ASSERT_TRUE(writer);
  Result<bool> done = false;
  for (int n = 0; n < 6; ++n) done = writer->Step();  // All of the list's sums.
  Put("own/log/2026-11-23", "a report that goes on");
  while (done && !*done) done = writer->Step();
  ASSERT_TRUE(done) << done.error().message();
  Collected read;
  ASSERT_TRUE(Read(OpenInput(file_).value(), read));
  EXPECT_EQ(read.files["own/log/2026-11-23"], "a report");
}

TEST_F(BackupTest, OfAFileThatGoesMeanwhileIsNotWritten) {
  auto writer = Writer::Begin(data_, {"a box", "today"}, file_);
  ASSERT_TRUE(writer);
  Result<bool> done = false;
  for (int n = 0; n < 6; ++n) done = writer->Step();  // All of the list's sums.
  std::filesystem::remove(data_ / "own/01-smile.toml");
  while (done && !*done) done = writer->Step();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().cause, std::errc::text_file_busy);
}

TEST_F(BackupTest, ThatIsNotWholeIsTakenOffTheStick) {
  {
    auto writer = Writer::Begin(data_, {"a box", "today"}, file_);
    ASSERT_TRUE(writer);
    ASSERT_TRUE(writer->Step());
    EXPECT_TRUE(std::filesystem::exists(file_));
  }
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(BackupTest, ReplacesNoOtherFile) {
  std::ofstream(file_) << "somebody's";
  const auto writer = Writer::Begin(data_, {"a box", "today"}, file_);
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().cause, std::errc::file_exists);
  EXPECT_EQ(ReadFile(file_).value(), "somebody's");
}

}  // namespace
}  // namespace kaori::backup
