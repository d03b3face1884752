// Every program of the box that runs on beats for the service manager while it has nothing to do. The test plays the manager.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/core/update/pending.h"
#include "tests/drivers/fat_fixture.h"
#include "tests/drivers/service_manager.h"
#include "tests/system/program_runner.h"

namespace kaori::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// What the manager allows: a program that beats four times in it does so each half a second.
constexpr const char* kSilence_us = "2000000";
constexpr Duration kFirstBeat = 20s;
// So many beats after the first one come in this time on a machine that is busy, and not where it is silent for 2 s each time.
constexpr int kBeats = 4;
constexpr Duration kLongestBeats = 7s;

// In `words` "%" stands for a folder of the test's own.
struct RunningProgram {
  std::string name, program;
  std::vector<std::string> words;
  friend void PrintTo(const RunningProgram& running, std::ostream* out) { *out << running.name; }
};

// One for each unit of the box that is no oneshot but the stage's, which needs a screen (watchdog_test.cpp).
std::vector<RunningProgram> RunningPrograms() {
  return {{"confirm", "kaori-update", {"--confirm",   "--notes",     "%/notes",    "--version", "%/version",
                                       "--slot",      "%/slot",      "--disk",     "%/disk",    "--variables",
                                       "%/variables", "--argument",  "%/argument", "--said",    "%",
                                       "--picture",   "%/none",      "--still",    "%/none",    "--last-face",
                                       "%/none",      "--systemctl", "/bin/true"}},
          {"desk",
           "kaori-desk",
           {"--service", "--board", "%/board", "--port", "0", "--plain", "--local", "--data", "%"}},
          {"fdkeeper", "kaori-fdkeeper", {"--socket", "%/socket"}},
          {"input", "kaori-input", {"--board", "%/board", "--links", "%"}},
          {"lips", "kaori-lips", {"--board", "%/board", "--links", "%"}},
          {"mending", "kaori-data", {"--board", "%/board", "--settings", "%"}},
          {"power", "kaori-power", {"--board", "%/board", "--notice", "%/notice", "--start", "%/start"}},
          {"report", "kaori-report", {"--board", "%/board", "--logs", "%", "--own", "%", "--shows", "%"}},
          {"reset", "kaori-data", {"--board", "%/board", "--reset", "%/reset", "--notice", "%/notice"}},
          {"shows",
           "kaori-shows",
           {"--board", "%/board", "--shows", "%/shows", "--root-keys", "%", "--keys", "%", "--open", "%/open",
            "--report", "%/report", "--stick", "%/stick", "--plugged", "--trial-user", "nobody", "--update",
            "%/socket"}},
          {"surface", "kaori-surface", {"--board", "%/board", "--updates", "%/shows"}},
          {"update",
           "kaori-update",
           {"--socket", "%/socket", "--notes", "%/notes", "--version", "%/version", "--slot", "%/slot",
            "--disk", "%/disk"}}};
}

class WatchedProgram : public ::testing::TestWithParam<RunningProgram> {
 protected:
  // A box in a folder: its board, its key, and a disk on which slot B is being tried.
  WatchedProgram() {
    ::setenv("WATCHDOG_USEC", kSilence_us, 1);
    for (const char* folder : {"disk", "notes", "shows", "variables"})
      fs::create_directory(programs_.File(folder));
    Write("open", "");
    Write("data_ruined", "/dev/none");
    Write("version", "version 12\nleast 10\n");
    Write("slot", "B");
    Write("notes/pending", update::Format(update::Pending{12, ports::Slot::kB, 1}));
    std::vector<std::uint8_t> boot(tests::FatFixture::kBytes);
    const tests::FatFixture fat(boot);
    Write("disk/boot", {boot.begin(), boot.end()});
    board_ = board::Board::Create(programs_.board());
  }
  ~WatchedProgram() override { ::unsetenv("WATCHDOG_USEC"); }

  void Write(const std::string& name, const std::string& text) {
    std::ofstream(programs_.File(name), std::ios::binary) << text;
  }
  void Start() {
    std::vector<std::string> words = GetParam().words;
    const std::string folder = fs::path(programs_.board()).parent_path();
    for (std::string& word : words)
      if (const auto at = word.find('%'); at != std::string::npos) word.replace(at, 1, folder);
    programs_.Start(GetParam().program, words);
  }
  // All beats until now.
  int Beats() {
    for (const std::string& said : manager_.Heard())
      beats_ += said.find("WATCHDOG=1") != std::string::npos ? 1 : 0;
    return beats_;
  }

  tests::Manager manager_;
  ProgramRunner programs_;
  Result<board::Board> board_ = Fail(std::errc::no_such_file_or_directory, "make a board");
  int beats_ = 0;
};

TEST_P(WatchedProgram, BeatsWhileItHasNothingToDo) {
  const std::string& program = GetParam().program;
  Start();
  ASSERT_TRUE(Await([&] { return Beats() > 0; }, kFirstBeat)) << programs_.LogOf(program);
  const int before = beats_;
  EXPECT_TRUE(Await([&] { return Beats() >= before + kBeats; }, kLongestBeats)) << programs_.LogOf(program);
  EXPECT_TRUE(programs_.Runs(program)) << programs_.LogOf(program);
}

INSTANTIATE_TEST_SUITE_P(OfTheBox, WatchedProgram, ::testing::ValuesIn(RunningPrograms()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace kaori::test
