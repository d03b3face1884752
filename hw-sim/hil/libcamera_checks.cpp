// The lip camera once more, brought by libcamera's handler of USB video instead of our own driver.
#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/paused_unit.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

// For machines that have little of a processor; libcamera itself needs seconds to start.
constexpr Duration kLibcameraAnswer = seconds(120);
constexpr Duration kLibcameraLongest = seconds(120);
constexpr double kWatched_s = 10;
// An empty name behind "libcamera:" stands for the first camera that it finds.
// Tools of the bench's disk: the image has no libcamera.
constexpr const char* kCameras = "tool kaori-lips --device libcamera: --modes";
// Of the kernel's own driver, which libcamera needs as well.
constexpr const char* kKernelsCamera = "read /sys/class/video4linux/video0/name";
constexpr const char* kLips = "start-tool kaori-lips --device libcamera: --board /run/kaori/board";

// What the lips measured over some seconds, by the machine's own clock. Errors: those of the board.
Result<double> FramesPerSecond(Scene& scene) {
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  scene.target.For(FromSeconds(kWatched_s));
  const auto after = scene.target.Board();
  if (!after) return tl::unexpected(after.error());
  return (after->lips_frames - before->lips_frames) /
         (static_cast<double>(after->now_ns - before->now_ns) / 1e9);
}

// The mouth is shut, watched, and opened, as in the check of the camera by V4L2.
Result<void> WatchLips(Scene& scene) {
  sim::LipCamera& camera = scene.target.rig().devices().camera;
  const auto seen = [](const BoardView& board) { return board.lips_live && board.lips_quality > 0.5; };
  camera.SetMouth(0.3, 1);
  const auto shut = scene.target.UntilBoard(seen, kLibcameraLongest, "see the lips through libcamera");
  if (!shut) return tl::unexpected(shut.error());
  const auto read_hz = FramesPerSecond(scene);
  if (!read_hz) return tl::unexpected(read_hz.error());
  camera.SetMouth(0.9, 1);
  const auto open = [&](const BoardView& board) { return board.lips_height > shut->lips_height + 0.3; };
  const auto opened = scene.target.UntilBoard(open, kLibcameraLongest, "see the mouth open");
  camera.SetMouth(0.25, 1);
  scene.finding.figures["libcamera_frames_per_s"] = *read_hz;
  scene.finding.said = fmt::format("{:.1f} frames/s measured by the lips; the mouth opened", *read_hz);
  if (!opened) return tl::unexpected(opened.error());
  return {};
}

// The tool is ended whatever it did, and its output is in the report.
Result<void> Libcamera(Scene& scene) {
  AgentProtocol& agent = scene.target.agent();
  // The box's own lip program must let go of the camera; it comes back whatever is found here.
  const PausedUnit lips(scene, "kaori-lips.service");
  // Without a camera nothing could be said of libcamera, and the control would only be skipped.
  if (const auto camera = agent.Ask(kKernelsCamera, kLibcameraAnswer); !camera)
    return FailInput("the kernel shows no camera: " + camera.error().message());
  const auto cameras = agent.Ask(kCameras, kLibcameraAnswer);
  scene.finding.texts.emplace_back("libcamera's cameras", cameras ? *cameras : cameras.error().message());
  // libcamera has no handler for every kernel's cameras: that is told, and no failure of the box.
  if (!cameras || cameras->find("libcamera:") == std::string::npos)
    return scene.Skip("libcamera shows no camera here; its output is in the report");
  const auto program = agent.Ask(kLips, kLibcameraAnswer);
  if (!program) return tl::unexpected(program.error());
  auto watched = WatchLips(scene);
  // The answer to start-tool names the program; that to "end" is what the program has said.
  const auto said = agent.Ask("end " + *program, kLibcameraAnswer);
  scene.finding.texts.emplace_back("kaori-lips", said ? *said : said.error().message());
  return watched;
}

}  // namespace

std::vector<Check> LibcameraChecks() {
  return {{.name = "libcamera",
           .sentence = "The lip camera by libcamera instead of V4L2",
           .run = Libcamera,
           .fails_without = "camera",
           .ends_programs = true}};
}

}  // namespace kaori::hil
