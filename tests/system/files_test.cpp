// Every option that names a file, with everything that is no such file.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/system/file_offers.h"
#include "tests/system/file_options.h"
#include "tests/system/program_runner.h"

namespace kaori::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr int kSecretKey_bytes = 64;
constexpr long kMostMemory_KiB = 400L << 10U;
constexpr auto kLongest = 10s;
constexpr auto kPlaysOn = 1s;  // After which a program that was given no fault is asked to end.

struct End {
  bool played_on = false;  // It was asked to end.
  int exit_status = -1;    // -1: a signal ended it.
  int signal = 0;
  long memory_KiB = 0;
};

class NoFile : public ::testing::TestWithParam<std::tuple<FileOption, Offer>> {
 protected:
  NoFile() : folder_(fs::path(::testing::TempDir()) / ("no-file-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    Fill(folder_ / "play", "");
    Fill(folder_ / "version", "version 2\nleast 1\n");
    Fill(folder_ / "slot", "A");
    Fill(folder_ / "key", "kaori-secret-key " + Repeated("5a", kSecretKey_bytes) + "\n");
  }
  ~NoFile() override { fs::remove_all(folder_); }

  pid_t Start(const FileOption& option) {
    std::vector<std::string> words{(ProgramRunner::Programs() / option.program).string()};
    for (std::string word : option.words) {
      if (word == "@") word = (folder_ / option.file).string();
      if (word == "#") word = (ProgramRunner::Programs().parent_path() / "shows" / "kaori.kaori").string();
      if (word.starts_with('%')) word = folder_.string() + word.substr(1);
      words.push_back(word);
    }
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child != 0) return child;
    const int log = ::creat((folder_ / "log").c_str(), 0600);
    ::dup2(log, STDERR_FILENO);
    ::dup2(log, STDOUT_FILENO);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }

  static End AwaitEnd(pid_t child, bool may_play_on) {
    End end;
    int status = 0;
    rusage used{};
    const auto ended = [&] { return ::wait4(child, &status, WNOHANG, &used) == child; };
    if (!Await(ended, may_play_on ? Duration(kPlaysOn) : Duration(kLongest))) {
      end.played_on = true;
      ::kill(child, SIGTERM);
      if (!Await(ended, kLongest)) {
        ::kill(child, SIGKILL);
        ::wait4(child, &status, 0, &used);
      }
    }
    end.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.memory_KiB = used.ru_maxrss;
    return end;
  }

  std::string Log() const {
    std::ostringstream text;
    text << std::ifstream(folder_ / "log").rdbuf();
    return text.str();
  }

  fs::path folder_;
};

TEST_P(NoFile, IsRefusedInALineThatNamesIt) {
  const auto& [option, offer] = GetParam();
  if (option.program == "kaori-gadget" && offer.name == "empty")
    GTEST_SKIP() << "an empty scenario is one, but there is no USB device controller here to play it";
  fs::create_directories((folder_ / option.file).parent_path());
  offer.put(folder_ / option.file);
  const auto is_of = [name = offer.name](const auto& names) {
    return std::ranges::find(names, name) != names.end();
  };
  const bool bears = is_of(option.bears);
  const End end = AwaitEnd(Start(option), bears);
  const std::string log = Log();
  EXPECT_EQ(end.signal, 0) << log;
  EXPECT_LT(end.memory_KiB, kMostMemory_KiB) << log;
  EXPECT_EQ(end.played_on, bears) << log;
  if (bears) return;
  EXPECT_THAT(log, ::testing::Not(::testing::HasSubstr("terminate called")));
  if (is_of(option.passes)) return;
  EXPECT_THAT(end.exit_status, ::testing::AnyOf(1, 2)) << log;
  EXPECT_THAT(log, ::testing::HasSubstr(option.file));
}

INSTANTIATE_TEST_SUITE_P(Programs, NoFile,
                         ::testing::Combine(::testing::ValuesIn(FileOptions()),
                                            ::testing::ValuesIn(Offers())),
                         [](const auto& offered) {
                           return std::get<0>(offered.param).name + "_" + std::get<1>(offered.param).name;
                         });

// What the help of a program says of its options: "--name FILE" at the beginning of a line.
std::vector<std::string> FilesOfHelp(const std::string& program) {
  ProgramRunner runner;
  EXPECT_EQ(runner.RunToEnd(program, {"--help"}), 0) << program;
  const std::string help = runner.LogOf(program);
  static const std::regex option(R"(\n {2,}(--[a-z-]+) +(FILE|FOLDER))");
  std::vector<std::string> options;
  for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at)
    options.push_back((*at)[1]);
  return options;
}

// All that the build makes, of which CMake keeps the list.
std::vector<std::string> BuiltPrograms() {
  std::vector<std::string> programs;
  std::istringstream words(KAORI_BUILT_PROGRAMS);
  for (std::string program; words >> program;) programs.push_back(program);
  return programs;
}

TEST(NoFileIsForgotten, ByTheListOfThisTest) {
  const std::vector<FileOption> rows = FileOptions();
  const std::vector<std::string> programs = BuiltPrograms();
  ASSERT_THAT(programs,
              ::testing::IsSupersetOf({"kaori-stage", "kaori-shows", "kaori-bench", "kaori-benchmark"}));
  for (const std::string& program : programs) {
    if (NamesNoFile(program)) continue;
    const std::vector<std::string> options = FilesOfHelp(program);
    const auto is_row_of_it = [&](const FileOption& row) { return row.program == program; };
    EXPECT_TRUE(!options.empty() || std::ranges::any_of(rows, is_row_of_it))
        << program << " has no row in FileOptions, and no reason in files_not_offered.cpp";
    for (const std::string& option : options) {
      const bool offered = std::ranges::any_of(rows, [&](const FileOption& row) {
        return is_row_of_it(row) && std::ranges::find(row.words, option) != row.words.end();
      });
      EXPECT_TRUE(offered || NeedsNoRow(program, option))
          << program << " " << option << " has no row in FileOptions";
    }
  }
}

}  // namespace
}  // namespace kaori::test
