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
#include <functional>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/system/file_offers.h"
#include "tests/system/program_runner.h"

namespace kaori::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr long kMostMemory_KiB = 400L << 10U;
constexpr auto kLongest = 10s;
constexpr auto kPlaysOn = 1s;  // After which a program that was given no fault is asked to end.

// One option of one program. In `words` "@" stands for the file, "%" for a folder of the test's own, "#" for the show.
struct FileOption {
  std::string name, program;
  std::vector<std::string> words;
  // What this option can bear: then the program plays on.
  std::vector<std::string> bears{};
  std::string file = "file";  // Its name in the folder.
};

std::vector<std::string> NamesOfOffers() {
  std::vector<std::string> names;
  for (const Offer& offer : Offers()) names.push_back(offer.name);
  return names;
}

// Of the programs that the box runs.
std::vector<FileOption> OptionsOfTheBox() {
  const std::vector<std::string> all = NamesOfOffers();
  std::vector<std::string> all_but_folder = all;  // A file cannot take a folder's name.
  std::erase(all_but_folder, "folder");
  return {
      {"input_settings", "kaori-input", {"--board", "%/board", "--links", "%", "--settings", "@"}, {"empty"}},
      // Without a certificate that can be used the desk makes another one.
      {"desk_certificate",
       "kaori-desk",
       {"--service", "--board", "%/board", "--port", "0", "--local", "--data", "%"},
       all_but_folder,
       "desk.pem"},
      // What was kept is broken: the lips play on with what is usual, and say so.
      {"lips_settings", "kaori-lips", {"--board", "%/board", "--links", "%", "--settings", "@"}, all},
      {"lips_pack", "kaori-lips", {"--board", "%/board", "--links", "%", "--pack", "@"}},
      {"lips_trust",
       "kaori-lips",
       {"--board", "%/board", "--links", "%", "--pack", "%/none", "--trust", "@"}},
      // A device whose file is faulty is not played, and the others are.
      {"input_surfaces",
       "kaori-input",
       {"--board", "%/board", "--links", "%", "--surfaces", "%"},
       all,
       "knob.toml"},
      {"surface_update", "kaori-surface", {"--port", "1-1", "--update", "@"}},
      {"surface_updates", "kaori-surface", {"--updates", "%"}, all, "dial-box.update"},
      // The show's own roles play, and it begins with its first face.
      {"stage_own",
       "kaori-stage",
       {"--board", "%/board", "--links", "%", "--pack", "#", "--own", "%"},
       all,
       "roles.toml"},
      {"stage_last_face",
       "kaori-stage",
       {"--board", "%/board", "--links", "%", "--own", "%", "--pack", "#", "--last-face", "@"},
       all},
      {"stage_evening",
       "kaori-stage",
       {"--board", "%/board", "--links", "%", "--own", "%", "--pack", "#", "--evening", "@", "--without",
        "lips"}},
      {"stage_pack", "kaori-stage", {"--board", "%/board", "--links", "%", "--pack", "@"}},
      {"stage_rehearse", "kaori-stage", {"--rehearse", "@"}},
      {"stage_trust",
       "kaori-stage",
       {"--board", "%/board", "--links", "%", "--pack", "%/none", "--trust", "@"}},
  };
}

// Of the programs that a maker of shows runs.
std::vector<FileOption> OptionsOfTools() {
  return {
      {"sim_play", "kaori-sim", {"--links", "%/links", "--play", "@"}, {"empty"}},
      {"sim_labels", "kaori-sim", {"--links", "%/links", "--console", "0", "--labels", "@"}},
      {"gadget_play", "kaori-gadget", {"--put", "keyboard=none", "--play", "@"}},
      {"rehearsal_pack", "kaori-rehearsal", {"--play", "%/play", "--pack", "@"}},
      {"rehearsal_play", "kaori-rehearsal", {"--pack", "%/none", "--play", "@"}},
      {"rehearsal_log", "kaori-rehearsal", {"--pack", "%/none", "--log", "@"}},
      {"atelier_report", "kaori-atelier", {"report", "%/none", "@"}},
      {"status_board", "kaori-status", {"--settings", "%", "--board", "@"}},
      {"atelier_info", "kaori-atelier", {"info", "@"}},
      {"atelier_diff", "kaori-atelier", {"diff", "@", "@"}},
      {"atelier_labels", "kaori-atelier", {"labels", "@", "%/labels.json"}},
      {"atelier_keys", "kaori-atelier", {"keys", "@", "%/keys"}},
      {"atelier_sign", "kaori-atelier", {"pack", "%", "%/out", "--sign", "@"}},
      {"atelier_show", "kaori-atelier", {"check", "%"}, {}, "show.toml"},
      {"atelier_cast", "kaori-atelier", {"check", "%"}, {}, "cast.toml"},
      {"atelier_import_gltf", "kaori-atelier", {"import", "@", "--out", "%/out"}, {}, "head.gltf"},
      {"atelier_import_obj", "kaori-atelier", {"import", "@", "--out", "%/out"}, {}, "head.obj"},
  };
}

std::vector<FileOption> FileOptions() {
  std::vector<FileOption> options = OptionsOfTheBox();
  std::ranges::move(OptionsOfTools(), std::back_inserter(options));
  return options;
}

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
  offer.put(folder_ / option.file);
  const bool bears = std::ranges::find(option.bears, offer.name) != option.bears.end();
  const End end = AwaitEnd(Start(option), bears);
  const std::string log = Log();
  EXPECT_EQ(end.signal, 0) << log;
  EXPECT_LT(end.memory_KiB, kMostMemory_KiB) << log;
  EXPECT_EQ(end.played_on, bears) << log;
  if (bears) return;
  EXPECT_THAT(end.exit_status, ::testing::AnyOf(1, 2)) << log;
  EXPECT_THAT(log, ::testing::HasSubstr(option.file));
  EXPECT_THAT(log, ::testing::Not(::testing::HasSubstr("terminate called")));
}

INSTANTIATE_TEST_SUITE_P(Programs, NoFile,
                         ::testing::Combine(::testing::ValuesIn(FileOptions()),
                                            ::testing::ValuesIn(Offers())),
                         [](const auto& offered) {
                           return std::get<0>(offered.param).name + "_" + std::get<1>(offered.param).name;
                         });

// Options of the help texts that name a file and need no row above, each with the reason.
const std::map<std::string, std::string>& NotOffered() {
  static const std::map<std::string, std::string> reasons{
      {"--address-file", "it is written"},
      {"--board", "board_lost_test.cpp spoils it while the programs run"},
      {"--links", "sockets are looked for in it, and nothing is read"},
      {"--shows", "a folder that one program alone writes; stage_chosen_show_test.cpp spoils what is in it"},
      {"kaori-data --notice", "it is written"},
      {"kaori-data --reset", "it is written"},
      {"kaori-data --settings", "kaori-boot leaves it in memory, and no person does"},
      {"kaori-desk --box", "a socket, at which it calls; what is none is refused by the kernel"},
      {"kaori-desk --open", "it is only asked whether it is there"},
      {"kaori-input --box", "a faulty one is no error: input_roles_test.cpp"},
      {"kaori-input --key", "it is written"},
      {"kaori-input --keys", "kaori-stage leaves it in memory, and no person does"},
      {"kaori-input --last-good", "it is written, and read as --box"},
      {"kaori-input --midi",
       "the kernel's folder of devices, or a simulator's sockets; browser_playing.test.mjs plays one"},
      {"kaori-input --turns", "it is written, and what is wrong in it is named: input_turns_test.cpp"},
      {"kaori-power --notice", "it is written"},
      {"kaori-power --start", "a damaged one is no error: power_last_start_test.cpp"},
      {"kaori-rehearsal --film", "it is written"},
      {"kaori-rehearsal --monitor", "it is written"},
      {"kaori-rehearsal --own", "it is read as kaori-stage reads it"},
      {"kaori-rehearsal --pictures", "it is written"},
      {"kaori-rehearsal --write-log", "it is written"},
      {"kaori-report --logs", "torn logs in it are named and left: report_test.cpp"},
      {"kaori-report --own", "what cannot be copied out of it is missing"},
      {"kaori-report --pack", "what is no show is that of no log: report_test.cpp"},
      {"kaori-sim --record", "it is written"},
      {"kaori-stage --card", "it is a device, and what is none is refused by the kernel"},
      {"kaori-stage --chosen", "kaori-shows leaves it in memory, and no person does"},
      {"kaori-stage --keys", "it is written"},
      {"kaori-stage --log", "it is written"},
      {"kaori-stage --looked-at", "it is only asked whether it is there"},
      {"kaori-stage --settings", "kaori-boot leaves it in memory, and no person does"},
      {"kaori-stage --still", "it is written"},
      {"kaori-status --picture", "it is written"},
  };
  return reasons;
}

bool NeedsNoRow(const std::string& program, const std::string& option) {
  return NotOffered().contains(option) || NotOffered().contains(fmt::format("{} {}", program, option));
}

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

TEST(NoFileIsForgotten, ByTheListOfThisTest) {
  const std::vector<FileOption> rows = FileOptions();
  std::set<std::string> programs;
  for (const FileOption& row : rows) programs.insert(row.program);
  for (const char* more : {"kaori-data", "kaori-power", "kaori-report"}) programs.insert(more);
  for (const std::string& program : programs)
    for (const std::string& option : FilesOfHelp(program)) {
      const bool offered = std::ranges::any_of(rows, [&](const FileOption& row) {
        return row.program == program && std::ranges::find(row.words, option) != row.words.end();
      });
      EXPECT_TRUE(offered || NeedsNoRow(program, option))
          << program << " " << option << " has no row in FileOptions";
    }
}

}  // namespace
}  // namespace kaori::test
