// What a program that crashes leaves, and what becomes of a show that ends the stage again and again.
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/process.h"
#include "hw-sim/hil/stick_scene.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

// Of an agent beside a face that takes all that the processors give.
constexpr Duration kCrashAnswer = seconds(120);
// It delivers all the time, so that its return is seen.
constexpr const char* kCrashing = "kaori-lips";
// What the program said since power came.
constexpr const char* kItsJournal = "own /usr/bin/journalctl -b --no-pager -o cat -n 300 -u kaori-lips";

// An instruction of the program itself, as a report names it (crash_report.h).
struct CrashFrame {
  // "0x12d9c", relative to the program's file.
  std::string address;
  // In hexadecimal digits.
  std::string build_id;
};

// The frames of the last report of a journal's text that lie in the program, the innermost first; none where there is no report.
std::vector<CrashFrame> FramesOf(const std::string& journal) {
  std::vector<CrashFrame> frames;
  std::istringstream lines(journal);
  const std::string module = std::string(kCrashing) + "+";
  for (std::string line; std::getline(lines, line);) {
    if (line.find(": crash: signal ") != std::string::npos) frames.clear();
    const std::size_t at = line.find(module);
    if (line.find(": crash: #") == std::string::npos || at == std::string::npos) continue;
    CrashFrame frame;
    std::istringstream(line.substr(at + module.size())) >> frame.address >> frame.build_id;
    frames.push_back(std::move(frame));
  }
  return frames;
}

// Ends the program by this signal, and waits until another process of its name delivers. Errors: timed_out.
Result<void> EndBy(Scene& scene, int signal) {
  const std::string processes = std::string("processes ") + kCrashing;
  const std::string before = TextInBox(scene, processes);
  const auto told = scene.target.agent().Ask(fmt::format("signal {} {}", kCrashing, signal), kCrashAnswer);
  if (!told) return tl::unexpected(told.error());
  if (before.empty() || *told != "1")
    return FailInput(fmt::format("{} does not run once, but {} times", kCrashing, *told));
  const auto ended = scene.target.Board();
  if (!ended) return tl::unexpected(ended.error());
  const auto is_back = [&](const BoardView& board) {
    const std::string now = TextInBox(scene, processes);
    return !now.empty() && now != before && board.lips_live && board.lips_at_ns > ended->now_ns;
  };
  const auto back =
      scene.target.UntilBoard(is_back, seconds(150), "see lips again after their program ended");
  if (!back) return tl::unexpected(back.error());
  return {};
}

// What the kept symbols say of a frame: "kaori::EventLoop::Run()", the innermost function of our own sources. Of a caller the
// address is that behind the call. Errors: invalid_argument, there are none of that build, or they do not know it.
Result<std::string> FunctionOf(Scene& scene, const CrashFrame& frame) {
  if (frame.build_id.size() < 3) return FailInput("the report does not say of which build the program is");
  const std::string symbols =
      fmt::format("{}/symbols/.build-id/{}/{}.debug", scene.target.machine().options().image,
                  frame.build_id.substr(0, 2), frame.build_id.substr(2));
  if (!std::filesystem::exists(symbols)) return FailInput("the build has kept no " + symbols);
  const std::string log = scene.folder + "/crash-function.log";
  const std::uint64_t call = std::strtoull(frame.address.c_str(), nullptr, 16) - 1;
  if (auto ok = RunToEnd({"addr2line", "-Cfie", symbols, fmt::format("{:#x}", call)}, log); !ok)
    return tl::unexpected(ok.error());
  const std::string said = ReadFile(log).value_or("");
  // Pairs of lines: a function, and its place. What was compiled into another function comes before that one.
  std::istringstream lines(said);
  for (std::string name, place; std::getline(lines, name) && std::getline(lines, place);)
    if (place.find("/appliance/") != std::string::npos || place.find("/drivers/") != std::string::npos)
      return name;
  return FailInput("the symbols say nothing of " + frame.address + ", but \"" + said + "\"");
}

// The innermost frame of a program that waits lies in libc; the program's own tell who called it.
// As long as the journal may take for what was said last.
Result<void> ACrashIsExplained(Scene& scene) {
  if (auto ok = EndBy(scene, SIGSEGV); !ok) return ok;
  std::string journal;
  std::vector<CrashFrame> frames;
  const auto is_reported = [&] {
    journal = TextInBox(scene, kItsJournal);
    frames = FramesOf(journal);
    return !frames.empty();
  };
  const bool reported = scene.target.Until(is_reported, seconds(30));
  scene.finding.texts.emplace_back("the journal of " + std::string(kCrashing), journal);
  if (!reported) return FailInput("the journal has no report of the crash");
  const auto function = FunctionOf(scene, frames.front());
  if (!function) return tl::unexpected(function.error());
  scene.finding.said = fmt::format(
      "{} ended by SIGSEGV and came back; its report has {} frames of its own, the innermost in {}",
      kCrashing, frames.size(), *function);
  return {};
}

// The control: a program that is killed cannot say anything, and no report is made up.
Result<void> AKilledProgramLeavesNoReport(Scene& scene) {
  const auto reports = [&] {
    const auto journal = scene.target.agent().Ask(kItsJournal, kCrashAnswer).value_or("");
    std::size_t count = 0;
    for (std::size_t at = 0; (at = journal.find(": crash: signal ", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  const std::size_t before = reports();
  if (auto ok = EndBy(scene, SIGKILL); !ok) return ok;
  return reports() == before ? Result<void>{} : FailInput("a program that was killed leaves a report");
}

// As store::kMostEnds, kRootShow (appliance/core/store).
constexpr int kEndsToGiveWay = 3;
constexpr const char* kOwnShow = "root";
constexpr Duration kLongestShown = std::chrono::minutes(5);

// How often the box has noted that a show ended the stage, and which one plays since (appliance/core/store/play_log.h).
bool HasNoted(Scene& scene, int ends, const std::string& playing) {
  const std::string plays = TextInBox(scene, "read /run/kaori/plays");
  int noted = 0;
  for (std::size_t at = 0; (at = plays.find("\nend ", at)) != std::string::npos; ++at) ++noted;
  return noted >= ends && plays.find("\nplaying " + playing + "\n") != std::string::npos;
}

// The stage crashes, and the next one notes that. It is not waited for until it draws: the ends are to lie within a minute.
Result<void> CrashTheStage(Scene& scene, int ends, const std::string& playing) {
  const std::string before = TextInBox(scene, "processes kaori-stage");
  const auto told = scene.target.agent().Ask(fmt::format("signal kaori-stage {}", SIGSEGV), kCrashAnswer);
  if (!told) return tl::unexpected(told.error());
  if (before.empty() || *told != "1") return FailInput("the stage does not run once");
  const auto noted = [&] {
    const std::string now = TextInBox(scene, "processes kaori-stage");
    return !now.empty() && now != before && HasNoted(scene, ends, playing);
  };
  if (scene.target.Until(noted, kLongestShown)) return {};
  return FailInput(
      fmt::format("after end {} the box notes: {}", ends, TextInBox(scene, "read /run/kaori/plays")));
}

// The show of a stick, which is brought in and plays; its id.
Result<std::string> BringEvening(Scene& scene) {
  scene.target.rig().gpio().Close(kStickKey);
  auto ok = BringKey(scene, "evening");
  if (ok) ok = PressFor(scene, kOne, "evening: it ");
  if (ok) ok = WantStickSaid(scene, "it is on the box and plays now", kLongestInstalling);
  auto id = ok ? ChosenId(scene) : Result<std::string>(tl::unexpected(ok.error()));
  scene.target.rig().gpio().Open(kStickKey);
  static_cast<void>(scene.target.machine().PullUnauthorised());
  if (!id) return id;
  if (auto plays = WantPlayed(scene, *id); !plays) return tl::unexpected(plays.error());
  return id;
}

// A stick's show that ends the stage so often, and what plays then.
Result<void> CrashAndSee(Scene& scene, int ends) {
  PlayStrategy box(scene.target);
  auto ok = box.Play(StickSetup(""));
  const auto id = ok ? BringEvening(scene) : Result<std::string>(tl::unexpected(ok.error()));
  if (!id) ok = tl::unexpected(id.error());
  // Ends that are given up on are forgotten.
  for (int n = 1; ok && n <= ends; ++n)
    ok = CrashTheStage(scene, n < kEndsToGiveWay ? n : 0, n < kEndsToGiveWay ? *id : kOwnShow);
  if (ok) ok = WantPlayed(scene, ends < kEndsToGiveWay ? *id : kOwnShow);
  if (ok) ok = scene.ShootFace("gives-way", fmt::format("After a stick's show crashed {} times", ends));
  scene.finding.texts.emplace_back(
      "the journal of kaori-stage",
      TextInBox(scene, "own /usr/bin/journalctl -b --no-pager -o cat -n 100 -u kaori-stage"));
  if (ok) box.Off();
  return ok;
}

// Of the shows that the box has the one before is its own.
Result<void> AShowThatCrashesGivesWay(Scene& scene) {
  scene.finding.said = "a stick's show ended the stage three times within a minute, and the box's own plays";
  return CrashAndSee(scene, kEndsToGiveWay);
}

// The control: after one end less it plays on.
Result<void> OneEndLessIsNoReason(Scene& scene) {
  return CrashAndSee(scene, kEndsToGiveWay - 1);
}

}  // namespace

std::vector<Check> GivesWayChecks() {
  return {
      {.name = "gives-way",
       .sentence = "A show that ends the stage three times within a minute gives way to the one before it",
       .run = AShowThatCrashesGivesWay,
       .setup = StickSetup(""),
       .control = OneEndLessIsNoReason,
       .powers = true,
       .stick = "evening"}};
}

std::vector<Check> CrashChecks() {
  return {{.name = "crash-report",
           .sentence = "A program that crashes says where, and the kept symbols explain it",
           .run = ACrashIsExplained,
           .control = AKilledProgramLeavesNoReport,
           .ends_programs = true}};
}

}  // namespace kaori::hil
