// The camera and the lines.
#include <fmt/format.h>

#include "hw-sim/bench/check.h"

namespace kaori::bench {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Duration kLongest = seconds(90);  // For machines that have little of a processor.
constexpr Duration kAnswer = seconds(60);
constexpr const char* kChip = "cp2112_gpio";

Result<std::string> Ask(Scene& scene, const std::string& question) {
  return scene.place.witness().Ask(question, kAnswer);
}

Result<void> Camera(Scene& scene) {
  constexpr double kSeconds = 10;
  sim::LipCamera& camera = scene.place.rig().instruments().camera;
  camera.SetMouth(0.3, 1);
  const auto seen = [](const BoardView& board) {
    return board.lips_live && board.lips_frames > 0 && board.lips_quality > 0.5;
  };
  const auto shut = scene.place.UntilBoard(seen, kLongest, "see the lips");
  if (!shut) return tl::unexpected(shut.error());
  const std::uint64_t sent = scene.place.rig().camera().frames_begun();
  scene.place.For(FromSeconds(kSeconds));
  const auto later = scene.place.Board();
  if (!later) return tl::unexpected(later.error());
  const double sent_per_s = static_cast<double>(scene.place.rig().camera().frames_begun() - sent) / kSeconds;
  const double read_per_s =
      (later->lips_frames - shut->lips_frames) / (static_cast<double>(later->now_ns - shut->now_ns) / 1e9);
  camera.SetMouth(0.9, 1);
  const auto open = [&](const BoardView& board) { return board.lips_height > later->lips_height + 0.3; };
  const auto opened = scene.place.UntilBoard(open, kLongest, "see the mouth open");
  camera.SetMouth(0.25, 1);
  scene.finding.figures["camera_frames_per_s"] = sent_per_s;
  scene.finding.figures["lips_frames_per_s"] = read_per_s;
  scene.finding.said =
      fmt::format("{:.1f} frames/s over the cable, {:.1f} measured by the lips", sent_per_s, read_per_s);
  if (!opened) return tl::unexpected(opened.error());
  return {};
}

Result<void> CameraPulled(Scene& scene) {
  static_cast<void>(scene.place.rig().Unplug("camera"));
  const auto gone = [](const BoardView& board) { return !board.lips_live; };
  if (auto ok = scene.place.UntilBoard(gone, kLongest, "see the camera gone"); !ok)
    return tl::unexpected(ok.error());
  static_cast<void>(scene.place.rig().Plug("camera"));
  const Time plugged = scene.place.clock().now();
  const auto back = [](const BoardView& board) { return board.lips_live && board.lips_quality > 0.5; };
  if (auto ok = scene.place.UntilBoard(back, kLongest, "see the lips again"); !ok)
    return tl::unexpected(ok.error());
  scene.finding.said =
      fmt::format("lips again {:.1f} s after the plug", Seconds(scene.place.clock().now() - plugged));
  return {};
}

// Numbers of the lines as docs/image.md wires them.
enum Line { kGo = 0, kBlackout = 1, kService = 2, kPresence = 3, kTally = 4 };

Result<void> WantEdge(Scene& scene, int line, bool active) {
  const std::string wanted = fmt::format("{} {} ", line, active ? 1 : 0);
  Result<std::string> edges;
  const Time until = scene.place.clock().now() + kLongest;
  while (scene.place.clock().now() < until) {
    edges = Ask(scene, "lines edges");
    if (!edges) return tl::unexpected(edges.error());
    if (edges->find(wanted) != std::string::npos) return {};
    scene.place.For(milliseconds(50));
  }
  return Fail(std::errc::timed_out, fmt::format("see line {} {}", line, active ? "active" : "inactive"));
}

// The bridge, and the kernel's chip on it; without the chip there is nothing to try.
Result<bool> HasChip(Scene& scene) {
  const auto chips = Ask(scene, "tool gpiodetect");
  return chips && chips->find(kChip) != std::string::npos;
}

Result<void> Lines(Scene& scene) {
  if (const auto there = HasChip(scene); !there || !*there)
    return scene.Skip("the kernel shows no chip for the bridge, or the bench's disk has no gpiodetect");
  if (auto ok = Ask(scene, fmt::format("lines take {} 0,1,2,3 4", kChip)); !ok)
    return tl::unexpected(ok.error());
  sim::GpioBridge& bridge = scene.place.rig().gpio();
  for (const int line : {kGo, kBlackout, kService, kPresence}) {
    bridge.Close(line);
    if (auto ok = WantEdge(scene, line, true); !ok) return ok;
    bridge.Open(line);
    if (auto ok = WantEdge(scene, line, false); !ok) return ok;
  }
  for (const bool lit : {true, false, true}) {
    if (auto ok = Ask(scene, fmt::format("lines drive 0 {}", lit ? 1 : 0)); !ok)
      return tl::unexpected(ok.error());
    if (!scene.place.Until([&] { return bridge.drives(kTally) && bridge.high(kTally) == lit; }, kLongest))
      return FailInput("the tally lamp does not follow");
  }
  scene.finding.said = "both edges of GO, blackout, service and presence; the tally lamp follows";
  return {};
}

}  // namespace

std::vector<Check> SourceChecks() {
  return {{"camera", "The lip camera streams, and the lips follow the mouth", true, Camera},
          {"camera-pulled", "The camera is pulled and plugged: the lips come back", true, CameraPulled},
          {"lines", "Switches and a lamp on GPIO lines, with edges", true, Lines}};
}

}  // namespace kaori::bench
