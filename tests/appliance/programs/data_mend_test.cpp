// What becomes of a data partition that cannot be mounted, with the real e2fsck and mke2fs on a file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <tuple>

#include <fmt/format.h>

#include "appliance/programs/data/folders.h"
#include "appliance/programs/data/mend.h"
#include "drivers/base/run_program.h"

namespace kaori::data {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::uint64_t kMiB = 1U << 20U;

class DataPartition : public ::testing::Test {
 protected:
  DataPartition() : folder_(fs::path(::testing::TempDir()) / fmt::format("data-partition-{}", ::getpid())) {
    fs::remove_all(folder_);
    for (const char* folder : {"kept/lips", "kept/settings", "kept/own"})
      fs::create_directories(folder_ / folder);
    std::ofstream(folder_ / "kept/lips/lips.settings") << "mouth.open = 0.7\n";
    std::ofstream(file()).flush();
    fs::resize_file(file(), 64 * kMiB);
    MakeFileSystem();
    EXPECT_TRUE(MakeFolders((folder_ / "empty").string(), kOfThisTest));
  }
  ~DataPartition() override { fs::remove_all(folder_); }

  // With all that is kept.
  void MakeFileSystem() const {
    EXPECT_EQ(Run({"/sbin/mke2fs", "-q", "-F", "-t", "ext4", "-d", (folder_ / "kept").string(), file()}), 0);
  }
  static int Run(const std::vector<std::string>& words) { return RunProgram(words).value_or(-1); }
  std::string file() const { return (folder_ / "data").string(); }

  // In systemd's place stands e2fsck, which only looks: what is not clean is not mounted. What is mounted is a copy of all files.
  Partition AsPartition() {
    return {.device = file(),
            .folders = (folder_ / "empty").string(),
            .kept = kOfThisTest,
            .place = place().string(),
            .pause = {},
            .run = [this](const auto& words) -> Result<int> {
              asked_.push_back(words[0] + " " + words[1]);
              if (words[0] != "/bin/systemctl") return RunProgram(words);
              if (words[1] != "start") return 0;
              auto status = RunProgram({"/sbin/e2fsck", "-f", "-n", file()});
              CopyTo(place());
              return status;
            }};
  }
  fs::path place() const { return folder_ / "place"; }

  // All that the file system has.
  void CopyTo(const fs::path& folder) const {
    fs::remove_all(folder);
    fs::create_directories(folder);
    Run({"/sbin/debugfs", "-R", fmt::format("rdump / {}", folder.string()), file()});
  }

  // Noise over a part of the file.
  void Ruin(std::uint64_t from, std::uint64_t bytes) const {
    std::mt19937 chance(7);  // NOLINT: the same noise each time.
    std::string noise(bytes, '\0');
    for (char& byte : noise) byte = static_cast<char>(chance());
    std::fstream(file(), std::ios::binary | std::ios::in | std::ios::out)
        .seekp(static_cast<std::streamoff>(from))
        .write(noise.data(), static_cast<std::streamsize>(bytes));
  }

  // A file of the file system; empty where it is not there.
  std::string Kept(const std::string& path) const {
    const std::string copy = (folder_ / "copy").string();
    fs::remove(copy);
    Run({"/sbin/debugfs", "-R", fmt::format("dump {} {}", path, copy), file()});
    std::ifstream stream(copy);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  bool HasFolder(const std::string& name) const {
    CopyTo(folder_ / "all");
    return fs::is_directory(folder_ / "all" / name);
  }

  static constexpr std::array<Folder, 2> kOfThisTest{Folder{"settings", "root", 0755},
                                                     Folder{"own", "nobody", 0700}};
  fs::path folder_;
  std::vector<std::string> asked_;
};

TEST_F(DataPartition, KeepsWhatItHasWhereItsSuperblockAndGroupsAreZero) {
  Ruin(1024, 4096);
  EXPECT_EQ(Mend(AsPartition()), Mended::kSaved);
  EXPECT_EQ(Kept("/lips/lips.settings"), "mouth.open = 0.7\n");
}

TEST_F(DataPartition, KeepsWhatItHasWhereItsJournalIsGone) {
  ASSERT_EQ(Run({"/sbin/debugfs", "-w", "-R", "clri <8>", file()}), 0);
  EXPECT_EQ(Mend(AsPartition()), Mended::kSaved);
  EXPECT_EQ(Kept("/lips/lips.settings"), "mouth.open = 0.7\n");
}

TEST_F(DataPartition, IsMadeAnewWhereNothingIsLeft) {
  Ruin(0, 60 * kMiB);
  EXPECT_EQ(Mend(AsPartition()), Mended::kMadeAnew);
  EXPECT_EQ(Kept("/lips/lips.settings"), "");
  EXPECT_TRUE(HasFolder("settings"));
  EXPECT_TRUE(HasFolder("own"));
  EXPECT_EQ(asked_.front(), "/sbin/e2fsck -f") << "what can be saved is saved first";
}

// e2fsck's status is that of a file system from which nothing is lost, in all of these.
TEST_F(DataPartition, IsSaidToBeMendedInPartWhereSomeIsLost) {
  for (const char* change : {"clri /own", "clri /settings", "unlink /lips"}) {
    MakeFileSystem();
    ASSERT_EQ(Run({"/sbin/debugfs", "-w", "-R", change, file()}), 0);
    EXPECT_EQ(Mend(AsPartition()), Mended::kInPart) << change;
    for (const Folder& folder : kOfThisTest) EXPECT_TRUE(fs::is_directory(place() / folder.name)) << change;
  }
}

TEST_F(DataPartition, HasItsFoldersAgainWhereNoiseTookItsRoot) {
  Ruin(0, 7 * kMiB);  // The first copy of the superblock lies behind it.
  EXPECT_EQ(Mend(AsPartition()), Mended::kInPart);
  EXPECT_TRUE(fs::is_directory(place() / "settings"));
  EXPECT_TRUE(fs::is_directory(place() / "own"));
}

TEST_F(DataPartition, IsLeftAloneWhereTheCheckCameToNoEnd) {
  constexpr int kCancelled = 32, kUsage = 16, kKilled = 137;
  for (const int status : {kCancelled, kUsage, kKilled}) {
    asked_.clear();
    Partition killed = AsPartition();
    killed.run = [&, run = killed.run](const std::vector<std::string>& words) -> Result<int> {
      return words[0] == "/sbin/e2fsck" ? status : run(words);
    };
    EXPECT_FALSE(Mend(killed)) << status;
    EXPECT_TRUE(asked_.empty()) << "nothing else is run: " << asked_.front();
    EXPECT_EQ(Kept("/lips/lips.settings"), "mouth.open = 0.7\n") << status;
  }
}

// e2fsck's 4 says that errors are left, and its 8 also that the device is busy, or could not be read.
TEST_F(DataPartition, IsCheckedAgainBeforeAnythingIsLost) {
  for (const int status : {4, 8, 12}) {
    Partition busy = AsPartition();
    int checks = 0;
    busy.run = [&, run = busy.run](const std::vector<std::string>& words) -> Result<int> {
      return words[0] == "/sbin/e2fsck" && ++checks < 3 ? status : run(words);
    };
    EXPECT_EQ(Mend(busy), Mended::kSaved) << status;
    EXPECT_EQ(Kept("/lips/lips.settings"), "mouth.open = 0.7\n") << status;
  }
}

TEST_F(DataPartition, IsLeftAloneWhereItIsWholeAndNotMounted) {
  Partition refused = AsPartition();
  refused.run = [run = refused.run](const std::vector<std::string>& words) -> Result<int> {
    return words[1] == "start" ? 1 : run(words);
  };
  EXPECT_FALSE(Mend(refused));
  EXPECT_EQ(Kept("/lips/lips.settings"), "mouth.open = 0.7\n");
}

// A cut between any two programs leaves a partition that the next try mends.
TEST_F(DataPartition, IsMendedByTheNextTryWherePowerWasCut) {
  for (std::size_t last = 1; last <= 7; ++last) {
    Ruin(0, 60 * kMiB);
    Partition cut = AsPartition();
    std::size_t count = 0;
    cut.run = [&, run = cut.run](const std::vector<std::string>& words) -> Result<int> {
      return ++count > last ? Fail(std::errc::io_error, "the power is off") : run(words);
    };
    static_cast<void>(Mend(cut));
    EXPECT_TRUE(Mend(AsPartition())) << "cut after program " << last;
    EXPECT_TRUE(HasFolder("own")) << "cut after program " << last;
  }
}

TEST_F(DataPartition, ThatTakesNothingIsAnErrorThatNamesTheProgram) {
  Partition broken = AsPartition();
  broken.run = [](const auto&) -> Result<int> { return 8; };
  const auto mended = Mend(broken);
  ASSERT_FALSE(mended);
  EXPECT_THAT(mended.error().message(), HasSubstr("mke2fs"));
  EXPECT_THAT(mended.error().message(), HasSubstr(file()));
}

TEST_F(DataPartition, FoldersHaveTheirModesAndOwners) {
  struct stat own {};
  ASSERT_EQ(::stat((folder_ / "empty/own").c_str(), &own), 0);
  EXPECT_EQ(own.st_mode & 07777U, 0700U);
  if (::geteuid() == 0) {
    EXPECT_EQ(own.st_uid, 65534U);
  }
  constexpr std::array<Folder, 1> kUnknown{Folder{"own", "nobody-of-that-name", 0700}};
  const auto made = MakeFolders((folder_ / "other").string(), kUnknown);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message(), HasSubstr("nobody-of-that-name"));
}

TEST(DataFaults, SayWhatBecameOfThePartition) {
  const std::string before =
      "box.toml:3: there is no profile \"stge\"\nthe data partition /dev/vda5 cannot be mounted: nothing is "
      "kept\nデータの領域に問題があります\n";
  for (const auto& [mended, said, japanese] :
       {std::tuple{Mended::kSaved, "could be saved is there", "データの領域を修復しました。"},
        std::tuple{Mended::kInPart, "in part", "一部は失われました"},
        std::tuple{Mended::kMadeAnew, "is lost", "前の内容は失われました"}}) {
    const std::string after = FaultsAfter(before, mended);
    EXPECT_THAT(after, HasSubstr("stge"));
    EXPECT_THAT(after, AllOf(HasSubstr(said), HasSubstr(japanese)));
    EXPECT_THAT(after, Not(HasSubstr("問題")));
    EXPECT_THAT(after, Not(HasSubstr("cannot be mounted")));
  }
}

}  // namespace
}  // namespace kaori::data
