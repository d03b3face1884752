// GPIO lines through the bridge: what foot switch and blackout do to the show, and the tally lamp.
#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/picture.h"
#include "hw-sim/hil/unplugged_device.h"

namespace kaori::hil {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Duration kLineLongest = seconds(90);  // For machines that have little of a processor.
// From frame to frame the picture fades: a slow machine needs as long as its frames take.
constexpr Duration kLongestFade = seconds(300);
constexpr std::uint32_t kFade = 30;  // Frames, after which it is over.
// Of the picture's points that are lit: a black picture has none, and some of noise is forgiven.
constexpr double kBlack = 0.004;

// Numbers of the bridge's lines as docs/image.md wires them. The tally lamp is an output; the others are
// switches.
enum Line { kGo = 0, kBlackout = 1, kService = 2, kPresence = 3, kTally = 4, kBack = 5, kPanic = 6 };

// The line's number on the board, which counts switches alone.
unsigned OnBoard(int line) {
  return static_cast<unsigned>(line < kTally ? line : line - 1);
}

// The box's own program has the lines. On a PC whose bridge is plugged in they must come: its kernel has the bridge's driver. Where
// they cannot be expected, on other processors' boxes or without the cable, they are tried where they come.
Result<bool> HasLines(Scene& scene) {
  const auto live = [](const BoardView& board) { return board.lines_live; };
  if (scene.target.UntilBoard(live, kLineLongest, "see the lines")) return true;
  const bool plugged = scene.target.rig().port("gpio")->plugged();
  const bool is_pc = scene.target.machine().options().architecture == Architecture::kAmd64;
  if (plugged && is_pc) return FailInput("the bridge is plugged in, and its lines are not on the board");
  return false;
}

// Tries what wants the lines.
Result<void> WithLines(Scene& scene, Result<void> (*work)(Scene&)) {
  const auto has_lines = HasLines(scene);
  if (!has_lines) return tl::unexpected(has_lines.error());
  if (!*has_lines) return scene.Skip("the kernel shows no chip for the bridge");
  return work(scene);
}

// Waits until the board has the line so. Errors: timed_out.
Result<void> WantLine(Scene& scene, int line, bool on) {
  const auto stands = [&](const BoardView& board) {
    return (board.lines_active >> OnBoard(line) & 1U) == (on ? 1U : 0U);
  };
  const auto seen =
      scene.target.UntilBoard(stands, kLineLongest, fmt::format("see line {} {}", line, on ? "on" : "off"));
  if (!seen) return tl::unexpected(seen.error());
  return {};
}

// Moves a switch, and waits until the board has seen it.
Result<void> Switch(Scene& scene, int line, bool on) {
  sim::GpioBridge& bridge = scene.target.rig().gpio();
  on ? bridge.Close(line) : bridge.Open(line);
  return WantLine(scene, line, on);
}

// Looks at the bridge's line itself: what the box drives, not what it says.
Result<void> WantTally(Scene& scene, bool lit) {
  sim::GpioBridge& bridge = scene.target.rig().gpio();
  const auto shows = [&] { return bridge.drives(kTally) && bridge.high(kTally) == lit; };
  if (scene.target.Until(shows, kLineLongest)) return {};
  return FailInput(fmt::format("the tally lamp is not {}", lit ? "lit" : "dark"));
}

// Opens all switches at its end, also where a check or its control ends before its time: while the service key is on
// sticks are authorised, in each check that follows.
class SwitchesOpenAfterwards {
 public:
  explicit SwitchesOpenAfterwards(Scene& scene) : bridge_(scene.target.rig().gpio()) {}
  ~SwitchesOpenAfterwards() {
    for (const int line : {kGo, kBlackout, kService, kPresence, kBack, kPanic}) bridge_.Open(line);
  }
  SwitchesOpenAfterwards(const SwitchesOpenAfterwards&) = delete;
  SwitchesOpenAfterwards& operator=(const SwitchesOpenAfterwards&) = delete;

 private:
  sim::GpioBridge& bridge_;
};

// Lines that change nothing on the screen: they are seen on the board alone.
// Both ways, each by itself.
Result<void> AllSwitches(Scene& scene) {
  for (const int line : {kService, kPresence})
    for (const bool on : {true, false})
      if (auto ok = Switch(scene, line, on); !ok) return ok;
  return {};
}

// A push of the foot switch plays the cue that stands by; its release does nothing.
Result<void> Go(Scene& scene) {
  // A cue that comes by itself would be taken for the foot's.
  const auto quiet = [](const BoardView& board) { return board.cue_pending < 0; };
  const auto before = scene.target.UntilBoard(quiet, kLineLongest, "see that no cue comes by itself");
  if (!before) return tl::unexpected(before.error());
  if (auto ok = Switch(scene, kGo, true); !ok) return ok;
  const auto next = [&](const BoardView& board) { return board.cue_active == before->cue_standby; };
  const auto called = scene.target.UntilBoard(next, kLineLongest, "see the cue that stood by");
  if (!called) return tl::unexpected(called.error());
  return Switch(scene, kGo, false);
}

// Pushed one after the other; what they do to the list is the performance's, and tried there. PANIC ends with
// the panic scene, from which the list goes on.
Result<void> BackAndPanic(Scene& scene) {
  for (const int line : {kBack, kPanic})
    for (const bool on : {true, false})
      if (auto ok = Switch(scene, line, on); !ok) return ok;
  return {};
}

// The picture goes black, or shows a face again: looked at until it does. It fades from frame to frame, so
// that a machine which draws slowly is given frames, not seconds.
Result<void> WantPicture(Scene& scene, const std::string& name, bool black) {
  const Time until = scene.target.clock().now() + kLineLongest, latest = until + kLongestFade;
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  const auto faded = [&] {
    const auto board = scene.target.Board();
    return board && board->stage.frames - before->stage.frames >= kFade;
  };
  while (true) {
    if (auto ok = scene.Shoot(name, black ? "Blacked out" : "Lit"); !ok) return ok;
    const auto picture = LookAt(scene.folder + "/" + scene.finding.pictures.back().file);
    if (!picture) return tl::unexpected(picture.error());
    if (black ? picture->lit < kBlack : ShowsAFace(*picture)) return {};
    // Both limits: frames where they come, time where they do not.
    if (const Time now = scene.target.clock().now(); now > latest || (now > until && faded()))
      return FailInput(fmt::format("the picture is not {}: {}", black ? "black" : "lit", Describe(*picture)));
    // Only the last picture is kept.
    scene.finding.pictures.pop_back();
    scene.target.For(milliseconds(200));
  }
}

// The lamp says "on air": it is dark while the picture is black.
Result<void> Blackout(Scene& scene) {
  for (const bool black : {true, false}) {
    if (auto ok = Switch(scene, kBlackout, black); !ok) return ok;
    if (auto ok = WantTally(scene, !black); !ok) return ok;
    if (auto ok = WantPicture(scene, black ? "blackout" : "lit-again", black); !ok) return ok;
  }
  return {};
}

Result<void> PlayLines(Scene& scene) {
  const SwitchesOpenAfterwards opened(scene);
  if (auto ok = WantTally(scene, true); !ok) return ok;
  for (const auto& part : {AllSwitches, Go, BackAndPanic, Blackout})
    if (auto ok = part(scene); !ok) return ok;
  scene.finding.said =
      "service and presence, GO plays the cue that stood by, BACK and PANIC are seen, blackout and lit "
      "again; the "
      "tally lamp follows";
  return {};
}

// A cable of its own is pulled and plugged: the lines are requested again, and the lamp.
Result<void> PullLines(Scene& scene) {
  const SwitchesOpenAfterwards opened(scene);
  {
    const UnpluggedDevice bridge(scene, "gpio");
    const auto gone = [](const BoardView& board) { return !board.lines_live; };
    if (auto ok = scene.target.UntilBoard(gone, kLineLongest, "see the bridge gone"); !ok)
      return tl::unexpected(ok.error());
  }
  const Time plugged = scene.target.clock().now();
  const auto back = [](const BoardView& board) { return board.lines_live; };
  if (auto ok = scene.target.UntilBoard(back, kLineLongest, "see the bridge again"); !ok)
    return tl::unexpected(ok.error());
  scene.finding.said =
      fmt::format("lines again {:.1f} s after the plug", Seconds(scene.target.clock().now() - plugged));
  if (auto ok = WantTally(scene, true); !ok) return ok;
  return Go(scene);
}

// The lamp must not say that the show plays while nothing does.
Result<void> StopTheStage(Scene& scene) {
  const auto own = [&](const char* verb) {
    return scene.target.agent().Ask(std::string("own /usr/bin/systemctl ") + verb + " kaori-stage.service",
                                    kLineLongest);
  };
  if (auto ok = own("stop"); !ok) return tl::unexpected(ok.error());
  auto dark = WantTally(scene, false);
  if (auto ok = own("start"); !ok) return tl::unexpected(ok.error());
  if (!dark) return dark;
  scene.finding.said = "dark while the stage is stopped, lit once it plays again";
  return WantTally(scene, true);
}

// All lines are let go in the end: checks that follow find them open.
Result<void> Lines(Scene& scene) {
  return WithLines(scene, PlayLines);
}
Result<void> LinesPulled(Scene& scene) {
  return WithLines(scene, PullLines);
}
Result<void> TallyWithoutStage(Scene& scene) {
  return WithLines(scene, StopTheStage);
}

}  // namespace

std::vector<Check> LineChecks() {
  return {{"lines",
           "Switches on GPIO lines play the show, and a lamp follows it",
           true,
           Lines,
           {},
           "kaori-input.service"},
          {"lines-pulled",
           "The bridge is pulled and plugged: its lines are requested again",
           false,
           LinesPulled,
           {},
           "kaori-input.service"},
          {.name = "tally",
           .sentence = "The tally lamp is dark while the stage is away",
           .run = TallyWithoutStage,
           .fails_without = "kaori-input.service",
           .ends_programs = true}};
}

}  // namespace kaori::hil
