// What is on the screen, while it plays and while its program is away.
#include <algorithm>

#include <fmt/format.h>

#include "hw-sim/bench/check.h"
#include "hw-sim/bench/picture.h"
#include "hw-sim/scenario/player.h"
#include "hw-sim/scenario/reader.h"

namespace kaori::bench {
namespace {

using std::chrono::seconds;

constexpr Duration kLongestReturn = seconds(90);
constexpr Duration kLongestFrame = seconds(120);  // With a new style's shaders, on a busy machine.
constexpr int kShotsWhileAway = 12;

Result<PictureView> LastPicture(const Scene& scene) {
  return LookAt(scene.folder + "/" + scene.finding.pictures.back().file);
}

Result<void> Face(Scene& scene) {
  if (auto ok = scene.ShootFace("face", "The first face"); !ok) return ok;
  const auto picture = LastPicture(scene);
  if (!picture) return tl::unexpected(picture.error());
  const auto board = scene.place.Board();
  if (!board) return tl::unexpected(board.error());
  scene.finding.figures["llvmpipe_frames_per_s"] = board->stage.frames_per_s;
  scene.finding.said = fmt::format("{}; {:.1f} frames/s", Words(*picture), board->stage.frames_per_s);
  return {};
}

// A scenario on the bench: its time stands still while a slow machine draws.
class HeldPlay {
 public:
  HeldPlay(sim::Scenario scenario, Place& place)
      : place_(place), last_(place.clock().now()), player_(std::move(scenario), place.rig(), last_) {
    place.SetHands([this](Time now) {
      if (now > last_ && !held_) played_ += now - last_;
      last_ = now;
      player_.Perform(start_ + played_);
    });
  }
  ~HeldPlay() { place_.SetHands({}); }
  HeldPlay(const HeldPlay&) = delete;
  HeldPlay& operator=(const HeldPlay&) = delete;

  const sim::Scenario& scenario() const { return player_.scenario(); }
  void PlayUntil(Duration at) {
    held_ = false;
    place_.Until([&] { return player_.position() >= at; }, at + seconds(1));
    held_ = true;
  }
  // Until the screen shows hands as they are now. Errors: timed_out.
  Result<void> AwaitFrame(const std::string& scene) {
    const auto now = place_.Board();
    if (!now) return tl::unexpected(now.error());
    const auto drawn = [&](const BoardView& board) { return board.stage.read_ns >= now->now_ns; };
    if (auto ok = place_.UntilBoard(drawn, kLongestFrame, "wait for a frame of scene " + scene); !ok)
      return tl::unexpected(ok.error());
    return {};
  }

 private:
  Place& place_;
  Time last_;
  Time start_ = last_;
  Duration played_{};
  bool held_ = false;
  sim::Player player_;
};

// In each scene, when two thirds of it are over.
Result<void> ShootScene(Scene& scene, HeldPlay& play, std::size_t beat) {
  const auto& beats = play.scenario().beats;
  const Duration ends = beat + 1 < beats.size() ? beats[beat + 1].at : play.scenario().length;
  play.PlayUntil(beats[beat].at + (ends - beats[beat].at) * 2 / 3);
  if (auto ok = play.AwaitFrame(beats[beat].name); !ok) return ok;
  return scene.ShootFace("play", beats[beat].name);
}

Result<void> Play(Scene& scene) {
  auto scenario = sim::LoadScenario(scene.play);
  if (!scenario) return tl::unexpected(scenario.error());
  const auto before = scene.place.Board();
  if (!before) return tl::unexpected(before.error());
  HeldPlay play(std::move(*scenario), scene.place);
  const std::size_t all = play.scenario().beats.size();
  const std::size_t scenes = scene.scenes > 0 ? std::min(all, static_cast<std::size_t>(scene.scenes)) : all;
  for (std::size_t n = 0; n < scenes; ++n)
    if (auto ok = ShootScene(scene, play, n); !ok) return ok;
  if (scenes == all) play.PlayUntil(play.scenario().length);
  const auto after = scene.place.Board();
  if (!after) return tl::unexpected(after.error());
  scene.finding.said = fmt::format("{} scenes, {} frames; time stood still while a slow machine drew", scenes,
                                   after->stage.frames - before->stage.frames);
  return {};
}

// Nobody touches it: the face lives by itself, and takes what is plugged in at last.
Result<void> Alone(Scene& scene) {
  constexpr double kMoved = 0.002;  // Of the points.
  constexpr std::uint32_t kFrames = 4;
  if (auto ok = scene.ShootFace("alone", "Nothing is plugged in"); !ok) return ok;
  const auto before = scene.place.Board();
  if (!before) return tl::unexpected(before.error());
  const auto later = [&](const BoardView& board) {
    return board.stage.live && board.stage.frames >= before->stage.frames + kFrames;
  };
  if (auto ok = scene.place.UntilBoard(later, kLongestFrame, "see it play alone"); !ok)
    return tl::unexpected(ok.error());
  if (auto ok = scene.ShootFace("alone", "A little later"); !ok) return ok;
  const auto moved = Difference(scene.folder + "/" + scene.finding.pictures[0].file,
                                scene.folder + "/" + scene.finding.pictures[1].file);
  if (!moved) return tl::unexpected(moved.error());
  if (*moved < kMoved) return FailInput("nothing moves");
  if (auto ok = scene.place.PlugAll(); !ok) return ok;
  const auto found = [](const BoardView& board) {
    return board.surface_live && board.left.live && board.right.live && board.lips_live;
  };
  if (auto ok = scene.place.UntilBoard(found, kLongestReturn, "find what is plugged in at last"); !ok)
    return tl::unexpected(ok.error());
  scene.finding.said = fmt::format(
      "the face moved by itself ({:.1f} % of the points), then took what was plugged in", 100 * *moved);
  return {};
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
    if (auto ok = scene.ShootFace(
            "killed", fmt::format("{:.1f} s after the kill", Seconds(scene.place.clock().now() - killed)));
        !ok)
      return ok;
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

std::vector<Check> AloneChecks() {
  return {{"alone", "Without any device it plays by itself", false, Alone, {.plugged = false}}};
}

}  // namespace kaori::bench
