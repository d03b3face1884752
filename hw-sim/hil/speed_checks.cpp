// How fast the box draws where the bench draws for it, as a graphics card would.
#include <algorithm>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

const Setup kWindow{
    .plugged = false, .sound = false, .graphics = Graphics::kVirgl, .width_px = 960, .height_px = 540};
// As many as the stage of 1993 had at least: two processors draw here for the machine and for its card, as fast as
// they can on that day; a real card draws every frame of its screen.
constexpr double kLeast_hz = 10;
constexpr int kWindows = 4;  // The best of them counts: neighbours may have had the processors in others.
// Long enough for a hundred frames of a machine that is fast enough.
constexpr Duration kOfAWindow = seconds(8);
constexpr std::uint32_t kWarm = 40;  // Frames, in which shaders and skins come.
constexpr Duration kLongestWarm = seconds(180);

// How fast the box draws, and what it costs this computer.
struct Pace {
  double frames_hz = 0;  // By the machine's own clock.
  double worked_ms = 0;  // Of the processors' time, for each frame.
};

// Counts frames over a stretch of the machine's own time. Errors: those of the board.
Result<Pace> Measure(Scene& scene) {
  const auto before = scene.target.Board();
  const Duration worked = scene.target.machine().worked();
  if (!before) return tl::unexpected(before.error());
  scene.target.For(kOfAWindow);
  const auto after = scene.target.Board();
  if (!after) return tl::unexpected(after.error());
  const double frames = after->stage.frames - before->stage.frames;
  return Pace{frames / (static_cast<double>(after->now_ns - before->now_ns) / 1e9),
              // All of QEMU's threads: what draws for the machine is among them.
              1e3 * Seconds(scene.target.machine().worked() - worked) / std::max(1.0, frames)};
}

// Who in the machine had its processors.
void AddShares(Scene& scene, const std::string& when) {
  // systemd counts the time of each unit's control group since the unit began, in nanoseconds.
  constexpr const char* kShares =
      "own /usr/bin/systemctl show -p Id,CPUUsageNSec kaori-stage kaori-lips kaori-input systemd-journald";
  const auto told = scene.target.agent().Ask(kShares, seconds(60));
  scene.finding.texts.emplace_back("the processors' time " + when, told ? *told : told.error().message());
}

// The best of some windows counts, since a slower one says more about the neighbours than about the box.
Result<void> Virgl(Scene& scene) {
  const auto warm = [](const BoardView& board) { return board.stage.frames >= kWarm; };
  if (auto ok = scene.target.UntilBoard(warm, kLongestWarm, "see its first frames"); !ok)
    return tl::unexpected(ok.error());
  if (auto ok = scene.ShootFace("virgl", "Drawn by the bench for the box"); !ok) return ok;
  AddShares(scene, "before");
  Pace best;
  for (int n = 0; n < kWindows; ++n) {
    const auto pace = Measure(scene);
    if (!pace) return tl::unexpected(pace.error());
    if (pace->frames_hz > best.frames_hz) best = *pace;
  }
  AddShares(scene, "after");
  scene.finding.figures["frames_per_s"] = best.frames_hz;
  scene.finding.said = fmt::format("{:.1f} frames/s at {} x {}, each of {:.0f} ms of the processors' time",
                                   best.frames_hz, kWindow.width_px, kWindow.height_px, best.worked_ms);
  return best.frames_hz >= kLeast_hz ? Result<void>{} : FailInput(scene.finding.said);
}

}  // namespace

std::vector<Check> SpeedChecks() {
  return {{"virgl", "Drawn through virgl it moves as in 1993, or smoother", false, Virgl, kWindow,
           "kaori-stage.service"}};
}

}  // namespace kaori::hil
