// The last picture stays while the stage is away, and a box that hangs as a whole starts again.
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/held_picture.h"
#include "hw-sim/hil/picture.h"

namespace kaori::hil {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Duration kRecoveryAnswer = seconds(120);

// A small screen, so that the stage is back sooner; no devices, whose drivers would need time. The
// watchdog's machine is smaller yet: it only has to run.
const Setup kSmall{.plugged = false, .sound = false, .width_px = 480, .height_px = 270};
const Setup kWatched{
    .plugged = false, .sound = false, .watchdog_resets = true, .width_px = 320, .height_px = 180};

// How the stage is made to end. A stage that hangs before it knows its pace has 20 of its slowest turns so
// far, and never more than the two minutes of its unit.
struct Death {
  const char* name;
  const char* question;  // To the agent.
  int times;             // For a release four times as many.
  Duration longest;      // Until the stage draws again.
};

// Killed: no destructor runs. Stopped: as an update does it. Frozen: the
// watchdog of systemd must notice it.
constexpr std::array kDeaths{
    Death{"killed", "signal kaori-stage 9", 8, seconds(120)},
    Death{"stopped", "start /usr/bin/systemctl restart kaori-stage.service", 4, seconds(180)},
    Death{"frozen", "signal kaori-stage 19", 1, seconds(360)}};

// A program that was started beside the questions is waited for.
Result<void> Reap(Scene& scene, const Death& death, const std::string& number) {
  if (!std::string_view(death.question).starts_with("start ")) return {};
  const auto said = scene.target.agent().Ask("end " + number, kRecoveryAnswer);
  if (!said) return tl::unexpected(said.error());
  return {};
}

// The number of the process of that name; empty while there is none.
Result<std::string> ProcessOf(Scene& scene, const char* program) {
  return scene.target.agent().Ask(std::string("processes ") + program, kRecoveryAnswer);
}

// Looks at the screen without a pause until the stage, which has just been made to end, draws new frames. A
// new stage is known by its process: between two looks at the board of a slow machine it may have drawn more
// frames than the old one had.
Result<void> WatchOneDeath(Scene& scene, const Death& death, HeldPicture& held) {
  const auto before = ProcessOf(scene, "kaori-stage");
  if (!before) return tl::unexpected(before.error());
  const auto told = scene.target.agent().Ask(death.question, kRecoveryAnswer);
  if (!told) return tl::unexpected(told.error());
  std::int64_t began_ns = 0;  // When the new process was first seen; 0: it was not.
  const Time until = scene.target.clock().now() + death.longest;
  while (scene.target.clock().now() < until) {
    if (auto ok = held.Look(scene); !ok) return ok;
    const auto board = scene.target.Board();
    const auto process = ProcessOf(scene, "kaori-stage");
    if (board && process && began_ns == 0 && !process->empty() && *process != *before)
      began_ns = board->now_ns;
    if (board && began_ns != 0 && board->stage.live && board->stage.read_ns > began_ns)
      return Reap(scene, death, *told);
    scene.target.For(milliseconds(20));
  }
  return Fail(std::errc::timed_out, fmt::format("see the stage again that was {}", death.name));
}

// A new stage must have drawn more frames than its successor needs to be recognised.
Result<void> AwaitSomeFrames(Scene& scene) {
  constexpr std::uint32_t kSome = 8;
  const auto some = [](const BoardView& board) { return board.stage.live && board.stage.frames >= kSome; };
  const auto seen = scene.target.UntilBoard(some, seconds(120), "see some frames");
  if (!seen) return tl::unexpected(seen.error());
  return {};
}

// Every death is watched by pictures alone: what an audience would see.
Result<void> Held(Scene& scene) {
  auto held = HoldFace(scene, "held", "Before the stage ends for the first time");
  if (!held) return tl::unexpected(held.error());
  int deaths = 0;
  for (const Death& death : kDeaths)
    for (int n = 0; n < death.times; ++n, ++deaths) {
      if (auto ok = AwaitSomeFrames(scene); !ok) return ok;
      if (auto ok = WatchOneDeath(scene, death, *held); !ok) return ok;
    }
  scene.finding.counts = {
      {"held_frames_wrong", held->wrong}, {"held_pictures", held->pictures}, {"held_deaths", deaths}};
  scene.finding.said =
      fmt::format("the stage ended {} times; {} pictures, {} wrong; largest difference {:.3f} of {}", deaths,
                  held->pictures, held->wrong, held->largest, HeldPicture::kMovedByItself);
  return held->wrong == 0 ? Result<void>{} : FailInput(scene.finding.said);
}

// A black picture and the face upside down are found wrong.
Result<void> WrongPicturesAreFound(Scene& scene) {
  if (auto ok = scene.ShootFace("held-control", "The face"); !ok) return ok;
  const std::string face = scene.folder + "/" + scene.finding.pictures.back().file;
  const std::string other = scene.folder + "/held-control-other.png";
  for (const auto write : {WriteBlack, WriteUpsideDown}) {
    if (auto ok = write(face, other); !ok) return ok;
    const auto apart = MeanDifference(face, other);
    if (!apart) return tl::unexpected(apart.error());
    if (*apart <= HeldPicture::kMovedByItself)
      return FailInput(fmt::format("another picture differs by {:.3f} only", *apart));
  }
  return {};
}

// The device that systemd feeds. It says so in no log: it opens the device before there is a journal.
Result<void> WantArmed(Scene& scene) {
  const auto device =
      scene.target.agent().Ask("own /usr/bin/systemctl show -p WatchdogDevice", kRecoveryAnswer);
  if (!device) return tl::unexpected(device.error());
  if (device->find("=/dev/watchdog") != std::string::npos) return {};
  return FailInput("systemd does not feed the hardware's watchdog: " + *device);
}

// The system's first program is frozen: the machine must reset by itself, which ends QEMU.
Result<void> Restart(Scene& scene) {
  if (auto ok = WantArmed(scene); !ok) return ok;
  const Time frozen = scene.target.clock().now();
  // The agent is in the same group and freezes too: no answer is expected. SIGSTOP does not work on the
  // first program, and the freezer of its group does.
  static_cast<void>(scene.target.agent().Ask("write /sys/fs/cgroup/init.scope/cgroup.freeze 1", seconds(2)));
  // Twice the watchdog's time and more: emulation is slow.
  const bool ended = scene.target.Until([&] { return !scene.target.machine().runs(); }, seconds(400));
  const double after_s = Seconds(scene.target.clock().now() - frozen);
  scene.finding.figures["watchdog_restart_s"] = after_s;
  scene.finding.said = fmt::format("reset {:.0f} s after the first program was frozen", after_s);
  return ended ? Result<void>{} : FailInput("a box whose first program is frozen does not reset");
}

// The control: a box whose first program runs is not reset in twice the watchdog's time.
Result<void> RunningIsNotReset(Scene& scene) {
  scene.target.agent().Lose();
  scene.target.machine().Off();
  if (auto ok = scene.target.machine().On(); !ok) return ok;
  const bool ended = scene.target.Until([&] { return !scene.target.machine().runs(); }, seconds(240));
  scene.target.machine().Off();
  return ended ? FailInput("a box that runs is reset too") : Result<void>{};
}

}  // namespace

std::vector<Check> RecoveryChecks() {
  return {{.name = "held",
           .sentence = "The last picture stays while the stage is killed, stopped and hangs",
           .run = Held,
           .setup = kSmall,
           .control = WrongPicturesAreFound,
           .ends_programs = true,
           .most_rounds = 4},
          {"restart",
           "A box whose first program hangs is started again by its watchdog",
           false,
           Restart,
           kWatched,
           {},
           RunningIsNotReset}};
}

}  // namespace kaori::hil
