// How fast the box draws where the bench draws for it, as a graphics card would.
#include <algorithm>

#include <fmt/format.h>

#include "hw-sim/bench/check.h"

namespace kaori::bench {
namespace {

using std::chrono::seconds;

constexpr Setup kWindow{.plugged = false, .drawn_outside = true, .width_px = 960, .height_px = 540};
constexpr double kLeast_hz = 15;
constexpr int kWindows = 4;  // The best of them counts: neighbours may have had the processors in others.
constexpr Duration kOfAWindow = seconds(8);
constexpr std::uint32_t kWarm = 40;  // Frames, in which shaders and skins come.
constexpr Duration kLongestWarm = seconds(180);

// By the machine's own clock.
Result<double> FramesPerSecond(Scene& scene) {
  const auto before = scene.place.Board();
  if (!before) return tl::unexpected(before.error());
  scene.place.For(kOfAWindow);
  const auto after = scene.place.Board();
  if (!after) return tl::unexpected(after.error());
  return static_cast<double>(after->stage.frames - before->stage.frames) /
         (static_cast<double>(after->now_ns - before->now_ns) / 1e9);
}

Result<void> Virgl(Scene& scene) {
  const auto warm = [](const BoardView& board) { return board.stage.frames >= kWarm; };
  if (auto ok = scene.place.UntilBoard(warm, kLongestWarm, "see its first frames"); !ok)
    return tl::unexpected(ok.error());
  if (auto ok = scene.ShootFace("virgl", "Drawn by the bench for the box"); !ok) return ok;
  double best_hz = 0;
  for (int n = 0; n < kWindows; ++n) {
    const auto measured_hz = FramesPerSecond(scene);
    if (!measured_hz) return tl::unexpected(measured_hz.error());
    best_hz = std::max(best_hz, *measured_hz);
  }
  scene.finding.figures["virgl_frames_per_s"] = best_hz;
  scene.finding.said =
      fmt::format("{:.1f} frames/s at {} x {}", best_hz, kWindow.width_px, kWindow.height_px);
  return best_hz >= kLeast_hz ? Result<void>{} : FailInput(scene.finding.said);
}

}  // namespace

std::vector<Check> SpeedChecks() {
  return {{"virgl", "Drawn through virgl it is smooth", false, Virgl, kWindow}};
}

}  // namespace kaori::bench
