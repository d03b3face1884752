#include "hw-sim/hil/boot_command.h"

#include <array>
#include <cstdio>
#include <sstream>

#include <fmt/format.h>

#include "hw-sim/hil/picture.h"
#include "hw-sim/hil/start_times.h"
#include "hw-sim/hil/target.h"

namespace kaori::hil {
namespace {

// Emulated on a busy computer; a quiet one needs half a minute.
constexpr Duration kLongestBootTrace = std::chrono::minutes(10);
// Times are told to a hundredth of a second, and the log is a file that is read again.
constexpr Duration kReadAgain = std::chrono::milliseconds(20);

// What a line of the log says, and what it means; in this order.
struct Mark {
  std::string_view first, second;  // Both are in the line.
  const char* meaning;
};

// The lines are those of the kernel, of systemd and of the stage. `second` may
// be empty, which is in every line.
constexpr std::array kMarks{
    Mark{"Linux version", "", "the kernel begins"},
    Mark{"Run /usr/bin/kaori-boot", "",
         "the disk's root is found and verified; the first program shows the still"},
    Mark{"systemd", "running in system mode", "the system begins"},
    Mark{"Starting ", "kaori-stage", "the stage's program begins"},
    Mark{"the graphics card is open", "", "Mesa is loaded, the graphics card is open"},
    Mark{"kaori-stage: ", "is read", "the show is read"},
    Mark{" on", "is opened", "faces and shaders are ready"},
    Mark{kFirstPicture, "", "the first face is on the screen"}};

// Prints each mark once, as soon as the log has it.
class Trace {
 public:
  explicit Trace(Time began) : began_(began) {}

  // The whole log is passed in each time; read_ is how much of it was read before, in bytes.
  void Read(const std::string& console, Time now) {
    // A line that has no end yet is read with the next look.
    std::istringstream lines(console.substr(read_));
    std::string line;
    while (std::getline(lines, line) && !lines.eof()) {
      read_ += line.size() + 1;
      for (std::size_t n = 0; n < kMarks.size(); ++n)
        if (line.find(kMarks[n].first) != line.npos && line.find(kMarks[n].second) != line.npos) Pass(n, now);
    }
  }

  // The first picture is seen on the screen, since nothing is said of it.
  void Light(Time now) const {
    fmt::print("{:7.2f} s               (the screen shows the still)\n", Seconds(now - began_));
    std::fflush(stdout);
  }

  bool complete() const { return passed_.back(); }

 private:
  // A mark counts once: a program that is started again does not change the times of the first start.
  void Pass(std::size_t n, Time now) {
    if (passed_[n]) return;
    passed_[n] = true;
    fmt::print("{:7.2f} s  after {:5.2f}  {}\n", Seconds(now - began_),
               // Marks may be passed at one look: the time between them is not known then.
               Seconds(now - std::max(before_, began_)), kMarks[n].meaning);
    std::fflush(stdout);
    before_ = now;
  }

  Time began_, before_{};
  std::size_t read_ = 0;
  std::array<bool, kMarks.size()> passed_{};
};

// Returns when the last mark is passed. Errors: timed_out, also where the machine ends before.
Result<void> FollowTrace(Target& target, Time began, const std::string& shot) {
  Trace trace(began);
  bool lit = false;
  while (!trace.complete() && target.machine().runs() && target.clock().now() - began < kLongestBootTrace) {
    if (!lit && ShowsAnyPicture(target, shot)) {
      lit = true;
      trace.Light(target.clock().now());
    }
    trace.Read(target.machine().console(), target.clock().now());
    target.For(kReadAgain);
  }
  if (trace.complete()) return {};
  return Fail(std::errc::timed_out, "wait for the first face");
}

}  // namespace

// For a person at a computer: nothing is plugged in and no agent is there. Without a trace or a picture to
// take the machine runs until it ends by itself or its window is closed.
Result<void> Boot(QemuOptions machine, const BootOptions& options, const Clock& clock) {
  const std::string shot = machine.folder + "/shot.png", console = ConsolePath(machine);
  // The kernel's own lines are wanted, and "quiet" hides them.
  if (options.trace) machine.log_level = 7;
  auto target = Target::Open(std::move(machine), clock);
  if (!target) return tl::unexpected(target.error());
  (*target)->machine().SetUp({.plugged = false, .sound = false, .agent = false});
  const Time began = clock.now();
  if (auto ok = (*target)->machine().On(); !ok) return ok;
  fmt::print("the box runs; its log is {}\n", console);
  std::fflush(stdout);
  if (options.trace)
    if (auto ok = FollowTrace(**target, began, shot); !ok) return ok;
  if (!options.shot.empty()) {
    // The first frame is on the screen before systemd says that the stage has started.
    if (const auto times = AwaitStart(**target, began, shot); !times) return tl::unexpected(times.error());
    return (*target)->machine().Shoot(0, options.shot);
  }
  while (!options.trace && (*target)->machine().runs()) (*target)->For(std::chrono::seconds(1));
  return {};
}

}  // namespace kaori::hil
