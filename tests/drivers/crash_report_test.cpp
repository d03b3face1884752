// A program that a signal ends says where it was, and the build's symbols turn that into names.
#include "drivers/base/crash_report.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <barrier>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "drivers/base/program.h"
#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"

namespace kaori {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// Neither inlined nor a tail call: each has a frame of its own.
[[gnu::noinline]] void WriteToNowhere(volatile int* nowhere) {
  *nowhere = 1;
}

constexpr int kLineOfTheCall = __LINE__ + 3;
[[gnu::noinline]] void CrashForTheTest() {
  volatile int* volatile nowhere = nullptr;
  WriteToNowhere(nowhere);
  asm volatile("");
}

// `most` is larger than a stack has room for, which the compiler may not know.
[[gnu::noinline]] int OverflowTheStack(int depth, const volatile int& most) {
  std::array<volatile char, 1024> room{};
  room[0] = static_cast<char>(depth);
  return depth < most ? OverflowTheStack(depth + 1, most) + room[0] : 0;
}

struct Ended {
  std::string said;
  int signal = 0;
};

class CrashReport : public ::testing::Test {
 protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers report crashes for themselves";
#endif
    ASSERT_TRUE(std::filesystem::create_directories(folder_));
  }
  void TearDown() override {
    std::filesystem::remove_all(folder_);
  }

  // What a child says that begins as a program does and then runs `ends`, and the signal that ended it.
  Ended Run(const std::function<void()>& ends, bool in_journal = false) {
    const std::string file = folder_ / "said";
    const pid_t child = ::fork();
    if (child == 0) {
      const UniqueFd said(::open(file.c_str(), O_CREAT | O_WRONLY | O_TRUNC | O_CLOEXEC, 0600));
      ::dup2(said.get(), STDERR_FILENO);
      struct stat status {};
      ::fstat(STDERR_FILENO, &status);
      if (in_journal)
        ::setenv("JOURNAL_STREAM", fmt::format("{}:{}", status.st_dev, status.st_ino).c_str(), 1);
      BeginProgram("kaori-test");
      ends();
      ::_exit(0);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return {ReadFile(file).value_or(""), WIFSIGNALED(status) ? WTERMSIG(status) : 0};
  }

  // What the script makes of a report, with the symbols of the folders.
  std::string Explain(const std::string& report, const std::string& folders) {
    const std::string in = folder_ / "report", out = folder_ / "explained";
    std::ofstream(in) << report;
    const auto command =
        fmt::format("python3 -B {}/drivers/base/symbols.py {} {} >{} 2>&1", KAORI_SOURCES, folders, in, out);
    // Words of the test alone go to the shell.
    const int status = std::system(command.c_str());
    return fmt::format("{}status {}", ReadFile(out).value_or(""), WEXITSTATUS(status));
  }

  static std::string OwnFolder() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path().string();
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / fmt::format("kaori-crash-{}", ::getpid());
};

TEST_F(CrashReport, OfASegmentFaultNamesTheFunctionAndItsCaller) {
  const Ended ended = Run(CrashForTheTest);
  EXPECT_EQ(ended.signal, SIGSEGV);
  EXPECT_THAT(ended.said, StartsWith("kaori-test: crash: signal 11 after 0."));
  EXPECT_THAT(ended.said, ContainsRegex("kaori-test: crash: #0 test-crash\\+0x[0-9a-f]+ [0-9a-f]{40}\n"));
  const std::string explained = Explain(ended.said, "--in " + OwnFolder());
  EXPECT_THAT(explained, ContainsRegex("#0 test-crash\\+0x[0-9a-f]+  .*WriteToNowhere.* at "
                                       ".*crash_report_test.cpp:[0-9]+"));
  EXPECT_THAT(explained, ContainsRegex(fmt::format("#1 test-crash\\+0x[0-9a-f]+  .*CrashForTheTest.* at "
                                                   ".*crash_report_test.cpp:{}\n",
                                                   kLineOfTheCall)));
}

TEST_F(CrashReport, IsCriticalInTheJournalSoThatItIsOnTheDiskAtOnce) {
  EXPECT_THAT(Run(CrashForTheTest, true).said, StartsWith("<2>kaori-test: crash: signal 11 "));
}

TEST_F(CrashReport, IsLeftByEverySignalThatACrashRaisesAndNoneIsSwallowed) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGSYS, SIGABRT}) {
    const Ended ended = Run([signal] { ::raise(signal); });
    EXPECT_EQ(ended.signal, signal);
    EXPECT_THAT(ended.said, StartsWith(fmt::format("kaori-test: crash: signal {} ", signal)));
  }
}

TEST_F(CrashReport, HoldsNoPathAndFitsIntoOneWriteHoweverDeepTheStackIs) {
  const Ended ended = Run([] {
    const volatile int most = 1 << 30;
    OverflowTheStack(0, most);
  });
  EXPECT_EQ(ended.signal, SIGSEGV);
  EXPECT_EQ(std::count(ended.said.begin(), ended.said.end(), '\n'), 25);
  EXPECT_LE(ended.said.size(), 4096U);
  EXPECT_THAT(ended.said, Not(HasSubstr("/")));
}

TEST_F(CrashReport, IsOneWhereSeveralThreadsCrash) {
  constexpr int kThreads = 8;
  const Ended ended = Run([] {
    std::barrier at_once(kThreads);
    std::vector<std::thread> threads;
    for (int i = 0; i < kThreads; ++i)
      threads.emplace_back([&] {
        at_once.arrive_and_wait();
        CrashForTheTest();
      });
    for (std::thread& thread : threads) thread.join();
  });
  EXPECT_EQ(ended.signal, SIGSEGV);
  EXPECT_EQ(ended.said.find("crash: signal"), ended.said.rfind("crash: signal"));
}

TEST_F(CrashReport, OfACallOfNothingSaysThatMuch) {
  const Ended ended = Run([] {
    void (*volatile nothing)() = nullptr;
    nothing();
  });
  EXPECT_EQ(ended.signal, SIGSEGV);
  EXPECT_THAT(ended.said, HasSubstr("crash: #0 ?+0x0 -\n"));
}

TEST_F(CrashReport, OfAnotherBuildIsNotExplainedByThisOne) {
  const std::string report = Run(CrashForTheTest).said;
  const auto id = report.find(' ', report.find("+0x")) + 1;
  std::string other = report;
  other.replace(id, 4, report.substr(id, 4) == "0000" ? "1111" : "0000");
  const std::string explained = Explain(other, "--in " + OwnFolder());
  EXPECT_THAT(explained, ContainsRegex("#0 test-crash\\+0x[0-9a-f]+  no symbols of this build"));
  EXPECT_THAT(explained, ContainsRegex("#1 test-crash\\+0x[0-9a-f]+  .*CrashForTheTest"));
}

TEST_F(CrashReport, OfAnOlderImageIsExplainedByTheSymbolsThatItsBuildKept) {
  const std::string report = Run(CrashForTheTest).said;
  const std::string id = report.substr(report.find(' ', report.find("+0x")) + 1, 40);
  const auto kept = folder_ / ".build-id" / id.substr(0, 2);
  std::filesystem::create_directories(kept);
  std::filesystem::copy_file("/proc/self/exe", kept / (id.substr(2) + ".debug"));
  EXPECT_THAT(Explain(report, "--in " + folder_.string()), ContainsRegex("#0 .*WriteToNowhere"));
}

TEST_F(CrashReport, ThatIsNoneIsRefused) {
  EXPECT_EQ(Explain("kaori-stage: plays\n", "--in " + OwnFolder()),
            (folder_ / "report").string() + " holds no crash report\nstatus 1");
}

}  // namespace
}  // namespace kaori
