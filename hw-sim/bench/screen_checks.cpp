// What is on the screen, while it plays and while its program is away.
#include <fmt/format.h>

#include "hw-sim/bench/check.h"
#include "hw-sim/bench/picture.h"
#include "hw-sim/scenario/player.h"
#include "hw-sim/scenario/reader.h"

namespace kaori::bench {
namespace {

using std::chrono::seconds;

constexpr Duration kLongestReturn = seconds(90);
constexpr int kShotsWhileAway = 12;

Result<PictureView> LastPicture(const Scene& scene) {
  return LookAt(scene.folder + "/" + scene.finding.pictures.back().file);
}

std::string Words(const PictureView& picture) {
  return fmt::format("{}x{}, {:.0f} % lit, {} shades", picture.width_px, picture.height_px, 100 * picture.lit,
                     picture.colours);
}

Result<void> WantFace(const Scene& scene) {
  const auto picture = LastPicture(scene);
  if (!picture) return tl::unexpected(picture.error());
  if (!ShowsAFace(*picture)) return FailInput("no face is on the screen: " + Words(*picture));
  return {};
}

Result<void> Face(Scene& scene) {
  if (auto ok = scene.Shoot("face", "The first face"); !ok) return ok;
  const auto picture = LastPicture(scene);
  if (!picture) return tl::unexpected(picture.error());
  const auto board = scene.place.Board();
  if (!board) return tl::unexpected(board.error());
  scene.finding.figures["llvmpipe_frames_per_s"] = board->stage.frames_per_s;
  scene.finding.said = fmt::format("{}; {:.1f} frames/s", Words(*picture), board->stage.frames_per_s);
  return WantFace(scene);
}

// A picture in the middle of each scene.
Result<void> Play(Scene& scene) {
  auto scenario = sim::LoadScenario(scene.play);
  if (!scenario) return tl::unexpected(scenario.error());
  const auto before = scene.place.Board();
  if (!before) return tl::unexpected(before.error());
  sim::Player player(std::move(*scenario), scene.place.rig(), scene.place.clock().now());
  scene.place.SetHands([&player](Time now) { player.Perform(now); });
  const auto& beats = player.scenario().beats;
  Result<void> ok;
  for (std::size_t n = 0; ok && n < beats.size(); ++n) {
    const Duration ends = n + 1 < beats.size() ? beats[n + 1].at : player.scenario().length;
    const Duration middle = beats[n].at + (ends - beats[n].at) * 2 / 3;
    scene.place.Until([&] { return player.position() >= middle; }, middle + seconds(5));
    ok = scene.Shoot("play", beats[n].name);
    if (ok) ok = WantFace(scene);
  }
  scene.place.Until([&] { return player.finished(); }, player.scenario().length);
  scene.place.SetHands({});
  if (!ok) return ok;
  const auto after = scene.place.Board();
  if (!after) return tl::unexpected(after.error());
  const double frames = after->stage.frames - before->stage.frames;
  scene.finding.said = fmt::format("{} scenes in {:.0f} s, {:.0f} frames", beats.size(),
                                   Seconds(player.scenario().length), frames);
  return frames > 0 ? Result<void>{} : FailInput("no frame came while it played");
}

// The kernel keeps the last picture; systemd starts the program again.
Result<void> StageKilled(Scene& scene) {
  const auto before = scene.place.Board();
  if (!before) return tl::unexpected(before.error());
  const Time killed = scene.place.clock().now();
  if (const auto found = scene.place.witness().Ask("signal kaori-stage 9", seconds(10));
      !found || *found != "1")
    return FailInput("the stage could not be killed");
  for (int n = 0; n < kShotsWhileAway; ++n) {
    if (auto ok = scene.Shoot(
            "killed", fmt::format("{:.1f} s after the kill", Seconds(scene.place.clock().now() - killed)));
        !ok)
      return ok;
    if (auto ok = WantFace(scene); !ok) return ok;
    if (n > 0 && n + 1 < kShotsWhileAway)
      scene.finding.pictures.pop_back();  // The first and the last are shown.
    scene.place.For(std::chrono::milliseconds(150));
  }
  const auto returned = [&](const BoardView& board) {
    return board.stage.live && board.stage.frames != before->stage.frames &&
           board.now_ns - before->now_ns > 0;
  };
  if (auto ok = scene.place.UntilBoard(returned, kLongestReturn, "wait for the stage to come back"); !ok)
    return tl::unexpected(ok.error());
  scene.finding.said = fmt::format("a face on all {} pictures; back after {:.1f} s", kShotsWhileAway,
                                   Seconds(scene.place.clock().now() - killed));
  return {};
}

}  // namespace

std::vector<Check> ScreenChecks() {
  return {
      {"face", "The face is on the screen", true, Face},
      {"play", "A scenario plays through the box's own drivers", true, Play},
      {"stage-killed", "The stage is killed: its last picture stays, and it comes back", true, StageKilled}};
}

}  // namespace kaori::bench
