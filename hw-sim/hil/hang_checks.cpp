// A program that hangs delivers nothing for ever, unless it is noticed: the service manager's watchdog replaces it.
#include <array>
#include <functional>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

constexpr Duration kHangAnswer = seconds(120);
// Two seconds are wanted of a machine that has time; emulated, beside neighbours, it has little. A program
// that hangs before it knows its own pace has two minutes, as its unit says.
constexpr Duration kLongestHang = seconds(150);
// Many times what a program that knows its pace may hang: for so long one that nobody watches is seen not to come back.
constexpr Duration kNotReplaced = seconds(60);

// A program that is hung, and when it delivers: something that came after a moment of the machine's clock. What it left on the board
// before stays there, whoever holds the section now.
struct HungProgram {
  const char* name;
  bool (*delivers)(const BoardView& board, std::int64_t since_ns);
  // The figure of how long it was away.
  const char* back_s;
};

constexpr std::array kHungPrograms{HungProgram{"kaori-input",
                                               [](const BoardView& board, std::int64_t since_ns) {
                                                 return board.surface_live && board.left.live &&
                                                        board.right.live && board.input_at_ns > since_ns;
                                               },
                                               "hung_input_back_s"},
                                   HungProgram{"kaori-lips",
                                               [](const BoardView& board, std::int64_t since_ns) {
                                                 return board.lips_live && board.lips_frames > 0 &&
                                                        board.lips_at_ns > since_ns;
                                               },
                                               "hung_lips_back_s"}};

// The numbers of the processes of that name; empty while there is none.
Result<std::string> ProcessesOf(Scene& scene, const HungProgram& program) {
  return scene.target.agent().Ask(std::string("processes ") + program.name, kHangAnswer);
}

// Waits until the program delivers something that came after that moment. Errors: timed_out.
Result<void> WantDelivery(Scene& scene, const HungProgram& program, std::int64_t since_ns) {
  const auto delivers = [&](const BoardView& board) { return program.delivers(board, since_ns); };
  const auto seen =
      scene.target.UntilBoard(delivers, kLongestHang, fmt::format("see what {} delivers", program.name));
  if (!seen) return tl::unexpected(seen.error());
  return {};
}

// A program that has just started is watched by the two minutes of its unit, until it has told the service
// manager of less.
Result<void> WantPaceKnown(Scene& scene, const HungProgram& program) {
  const std::string question =
      fmt::format("own /usr/bin/systemctl show -p WatchdogUSec {}.service", program.name);
  Result<std::string> last;
  const auto is_known = [&] {
    last = scene.target.agent().Ask(question, kHangAnswer);
    return last && last->find("WatchdogUSec=") != std::string::npos && last->find("min") == std::string::npos;
  };
  if (scene.target.Until(is_known, kLongestHang)) return {};
  return FailInput(fmt::format("{} is watched with the longest patience still: {}", program.name,
                               last ? *last : last.error().message()));
}

// Hangs a program by SIGSTOP, and waits until another process of its name delivers what came since. Gives how long that took, by
// the machine's clock. Errors of ErrorKind::kInput: timed_out, the same process hangs still; invalid_argument, the new one delivers
// nothing. Others are the agent's.
Result<Duration> Hang(Scene& scene, const HungProgram& program, Duration longest) {
  const auto before = ProcessesOf(scene, program);
  if (!before) return tl::unexpected(before.error());
  if (before->empty()) return FailInput(fmt::format("{} does not run", program.name));
  if (auto ok = scene.Tell(fmt::format("signal {} 19", program.name)); !ok) return tl::unexpected(ok.error());
  // What is newer than this cannot be of the program that hangs.
  const auto hung = scene.target.Board();
  if (!hung) return tl::unexpected(hung.error());
  const auto is_back = [&](const BoardView& board) {
    const auto now = ProcessesOf(scene, program);
    return now && !now->empty() && *now != *before && program.delivers(board, hung->now_ns);
  };
  const auto back = scene.target.UntilBoard(is_back, longest, fmt::format("see {} again", program.name));
  if (back) return std::chrono::nanoseconds(back->now_ns - hung->now_ns);
  // An agent that answers no more has seen nothing of the program.
  const auto now = ProcessesOf(scene, program);
  if (!now) return tl::unexpected(now.error());
  if (*now == *before)
    return FailInput(fmt::format("{} hangs, and is not replaced", program.name), std::errc::timed_out);
  return FailInput(fmt::format("{} was replaced, and delivers nothing", program.name));
}

// The input program first: what it delivers is what the operators miss at once.
Result<void> Hung(Scene& scene) {
  for (const HungProgram& program : kHungPrograms) {
    if (auto ok = WantPaceKnown(scene, program); !ok) return ok;
    // From whenever: that it is there at all.
    if (auto ok = WantDelivery(scene, program, 0); !ok) return ok;
    const auto away = Hang(scene, program, kLongestHang);
    if (!away) return tl::unexpected(away.error());
    scene.finding.figures[program.back_s] = Seconds(*away);
  }
  auto& figures = scene.finding.figures;
  scene.finding.said = fmt::format(
      "stopped by SIGSTOP, the input program delivered again after {:.1f} s, the lips after {:.1f} s",
      figures["hung_input_back_s"], figures["hung_lips_back_s"]);
  return {};
}

// The program that hangs is killed, which its unit answers with a new one.
Result<void> BringBack(Scene& scene, const HungProgram& program) {
  const auto hung = scene.target.Board();
  auto ok = scene.Tell(fmt::format("signal {} 9", program.name));
  if (ok) ok = WantDelivery(scene, program, hung ? hung->now_ns : 0);
  return ok;
}

// Errors: invalid_argument, the program comes back; those of Hang, but for that it hangs still.
Result<void> WantHangsStill(Scene& scene, const HungProgram& program) {
  // Else it could not have been replaced so soon either way.
  if (auto ok = WantPaceKnown(scene, program); !ok) return ok;
  const auto away = Hang(scene, program, kNotReplaced);
  auto back = BringBack(scene, program);
  if (away) return FailInput(fmt::format("{} comes back although nobody watches it", program.name));
  const bool hangs_still =
      away.error().kind == ErrorKind::kInput && away.error().cause == std::errc::timed_out;
  return hangs_still ? back : tl::unexpected(away.error());
}

// The control: a program whose watchdog is off is never replaced, and the check says just that. All is as before afterwards, since
// the box is shared.
Result<void> UnwatchedIsNotReplaced(Scene& scene) {
  auto ok = scene.Tell("own /usr/bin/systemctl service-watchdogs no");
  for (const HungProgram& program : kHungPrograms)
    if (ok) ok = WantHangsStill(scene, program);
  const auto watched = scene.Tell("own /usr/bin/systemctl service-watchdogs yes");
  return ok ? watched : ok;
}

}  // namespace

std::vector<Check> HangChecks() {
  return {{.name = "hung",
           .sentence = "Input and lips that hang are replaced",
           .chosen = true,
           .run = Hung,
           .control = UnwatchedIsNotReplaced,
           .ends_programs = true}};
}

}  // namespace kaori::hil
