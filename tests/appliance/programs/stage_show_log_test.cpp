// The show log on the disk: one file for an evening, three evenings, and a disk that refuses.
#include "appliance/programs/stage/show_log.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

#include "tests/appliance/core/showlog_fixture.h"

namespace kaori::stage {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class ShowLogOnDisk : public performance::PerformanceTest {
 protected:
  ShowLogOnDisk() : folder_(fs::path(::testing::TempDir()) / fmt::format("show-log-{}", ::getpid())) {
    fs::remove_all(folder_);
  }
  ~ShowLogOnDisk() override { fs::remove_all(folder_); }

  // A stage that starts, plays a second, and ends. The file that it wrote.
  fs::path PlayASecond(const showlog::LogHead& head) {
    auto log = ShowLog::Open(folder_, head);
    EXPECT_TRUE(log) << log.error().message();
    if (!log) return {};
    for (int i = 0; i < 60; ++i) {
      now_ += performance::kFrame;
      const auto events = performance::ReadEvents(state_.seen, board_);
      performed_ = performance::Animate(state_, board_, events, show_, now_);
      (*log)->recorder().Note({now_, board_, state_, events}, performed_);
      state_ = performed_.state;
    }
    (*log)->Finish();
    return (*log)->file();
  }

  std::vector<std::string> Files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
  }

  static showlog::LogHead Evening(int day) {
    return {.show = 7, .booted_at = std::chrono::hours(24 * (20'000 + day))};
  }

  fs::path folder_;
};

TEST_F(ShowLogOnDisk, GoesOnInOneFileWhenTheStageIsStartedAgain) {
  const fs::path file = PlayASecond(Evening(1));
  showlog::LogHead again = Evening(1);
  again.booted_at += 20ms;  // The wall clock is never quite the same.
  EXPECT_EQ(PlayASecond(again), file);
  const auto log = showlog::LogFile::Read(file);
  ASSERT_TRUE(log) << log.error().message();
  EXPECT_EQ(log->chunks().size(), 2U);
  EXPECT_THAT(log->faults(), ::testing::IsEmpty());
  showlog::Replay replay(*log, show_);
  while (replay.Next()) {
  }
  EXPECT_EQ(replay.frames(), 120U);
  EXPECT_EQ(replay.frames_that_differ(), 0U);
}

TEST_F(ShowLogOnDisk, OfAnotherShowOrWithOtherRolesIsAnotherFile) {
  const fs::path file = PlayASecond(Evening(1));
  showlog::LogHead other = Evening(1);
  other.show = 8;
  const fs::path second = PlayASecond(other);
  EXPECT_NE(second, file);
  other.roles = "handover_s = 0.5\n";
  const fs::path third = PlayASecond(other);
  EXPECT_NE(third, second);
  const auto log = showlog::LogFile::Read(third);
  ASSERT_TRUE(log) << log.error().message();
  EXPECT_EQ(log->head().roles, other.roles);
}

TEST_F(ShowLogOnDisk, KeepsThreeEveningsAndWhatIsNoLog) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "notes.txt") << "left alone";
  for (int day = 1; day <= 5; ++day) PlayASecond(Evening(day));
  const auto files = Files();
  ASSERT_EQ(files.size(), 4U);
  EXPECT_TRUE(files[0].starts_with("0003-")) << files[0];
  EXPECT_TRUE(files[2].starts_with("0005-")) << files[2];
  EXPECT_EQ(files[3], "notes.txt");
}

TEST_F(ShowLogOnDisk, KeepsAHundredMegabytesOfOneEvening) {
  const fs::path file = PlayASecond(Evening(1));
  for (int copy = 2; copy <= 5; ++copy) {  // Sparse: they only look large.
    const fs::path large = folder_ / fmt::format("{:04}-20240101-190000.kaorilog", copy);
    fs::copy_file(file, large);
    fs::resize_file(large, showlog::kFullFile_bytes);
  }
  const fs::path newest = PlayASecond(Evening(1));
  EXPECT_EQ(newest.filename().string().substr(0, 5), "0006-");
  const auto files = Files();
  ASSERT_EQ(files.size(), 3U) << "two of 32 MiB and the new one";
  EXPECT_TRUE(files[0].starts_with("0004-")) << files[0];
}

TEST_F(ShowLogOnDisk, ThatCannotBeWrittenWholeEndsWithAWholePart) {
  const fs::path file = PlayASecond(Evening(1));
  const auto bytes = fs::file_size(file);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{bytes + 1000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  PlayASecond(Evening(1));
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(fs::file_size(file), bytes) << "what was written of it is cut off again";
  PlayASecond(Evening(1));
  const auto log = showlog::LogFile::Read(file);
  ASSERT_TRUE(log) << log.error().message();
  EXPECT_EQ(log->chunks().size(), 2U);
  EXPECT_THAT(log->faults(), ::testing::IsEmpty());
}

TEST_F(ShowLogOnDisk, InAFolderThatCannotBeMadeIsRefused) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "file") << "x";
  const auto log = ShowLog::Open(folder_ / "file" / "log", Evening(1));
  ASSERT_FALSE(log);
  EXPECT_THAT(log.error().message(), ::testing::HasSubstr("make the folder"));
}

}  // namespace
}  // namespace kaori::stage
