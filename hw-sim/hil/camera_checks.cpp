// The lip camera.
#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/unplugged_device.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

constexpr Duration kCameraLongest = seconds(90);  // For machines that have little of a processor.

// Of what the camera sends, that the lips measure at least.
constexpr double kLeastMeasured = 0.8;

// The mouth is shut, measured for some seconds, and opened.
Result<void> Camera(Scene& scene) {
  constexpr double kSeconds = 10;
  sim::LipCamera& camera = scene.target.rig().devices().camera;
  // Sizes are in widths of the mouth at rest: its height, and its width, which stays as it is.
  camera.SetMouth(0.3, 1);
  const auto seen = [](const BoardView& board) {
    // Half of what the lip reader is sure of at best.
    return board.lips_live && board.lips_frames > 0 && board.lips_quality > 0.5;
  };
  const auto shut = scene.target.UntilBoard(seen, kCameraLongest, "see the lips");
  if (!shut) return tl::unexpected(shut.error());
  // Frames over the cable and frames on the board are counted over the same
  // stretch of time, by two clocks.
  const std::uint64_t sent = scene.target.rig().camera().frames_begun();
  const Time began = scene.target.clock().now();
  scene.target.For(FromSeconds(kSeconds));
  const auto later = scene.target.Board();
  if (!later) return tl::unexpected(later.error());
  const double sent_per_s = static_cast<double>(scene.target.rig().camera().frames_begun() - sent) /
                            Seconds(scene.target.clock().now() - began);
  const double read_per_s =
      (later->lips_frames - shut->lips_frames) / (static_cast<double>(later->now_ns - shut->now_ns) / 1e9);
  camera.SetMouth(0.9, 1);
  // Three tenths of the mouth's width at rest: noise moves the height by some hundredths.
  const auto open = [&](const BoardView& board) { return board.lips_height > later->lips_height + 0.3; };
  const auto opened = scene.target.UntilBoard(open, kCameraLongest, "see the mouth open");
  camera.SetMouth(0.25, 1);
  scene.finding.figures["camera_frames_per_s"] = sent_per_s;
  scene.finding.figures["lips_frames_per_s"] = read_per_s;
  scene.finding.said =
      fmt::format("{:.1f} frames/s over the cable, {:.1f} measured by the lips", sent_per_s, read_per_s);
  if (!opened) return tl::unexpected(opened.error());
  if (sent_per_s <= 0 || read_per_s < kLeastMeasured * sent_per_s) return FailInput(scene.finding.said);
  return {};
}

// The braces plug the camera in again at their end, and the time counts from there.
Result<void> CameraPulled(Scene& scene) {
  {
    const UnpluggedDevice camera(scene, "camera");
    const auto gone = [](const BoardView& board) { return !board.lips_live; };
    if (auto ok = scene.target.UntilBoard(gone, kCameraLongest, "see the camera gone"); !ok)
      return tl::unexpected(ok.error());
  }
  const Time plugged = scene.target.clock().now();
  const auto back = [](const BoardView& board) { return board.lips_live && board.lips_quality > 0.5; };
  if (auto ok = scene.target.UntilBoard(back, kCameraLongest, "see the lips again"); !ok)
    return tl::unexpected(ok.error());
  scene.finding.said =
      fmt::format("lips again {:.1f} s after the plug", Seconds(scene.target.clock().now() - plugged));
  return {};
}

}  // namespace

std::vector<Check> CameraChecks() {
  return {{"camera",
           "The lip camera streams, and the lips follow the mouth",
           true,
           Camera,
           {},
           "kaori-lips.service"},
          {"camera-pulled",
           "The camera is pulled and plugged: the lips come back",
           true,
           CameraPulled,
           {},
           "kaori-lips.service"}};
}

}  // namespace kaori::hil
