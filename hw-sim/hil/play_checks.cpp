// Scenarios of input and of faults, played through the box's own drivers.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/scenario/player.h"
#include "hw-sim/scenario/reader.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

constexpr Duration kLongestFrame = seconds(300);  // With a new style's shaders, on a busy machine.

// A scenario on the bench: its time is paused while a slow machine draws, so that every
// scene is played to its end however long a frame takes. Plays within whatever waits on
// the target; ends with this object.
class HeldPlay {
 public:
  HeldPlay(sim::Scenario scenario, std::string name, Target& target)
      : name_(std::move(name)),
        target_(target),
        last_(target.clock().now()),
        player_(std::move(scenario), target.rig(), last_) {
    target.SetInput([this](Time now) {
      // The time since the last call counts only while the play is not held.
      if (now > last_ && !held_) played_ += now - last_;
      last_ = now;
      player_.Perform(start_ + played_);
    });
  }
  ~HeldPlay() { target_.SetInput({}); }
  HeldPlay(const HeldPlay&) = delete;
  HeldPlay& operator=(const HeldPlay&) = delete;

  const std::string& name() const { return name_; }  // Of its pictures.
  const sim::Scenario& scenario() const { return player_.scenario(); }
  // Plays up to a time of the scenario, and holds it there. Blocks for as long as that takes.
  void PlayUntil(Duration at) {
    held_ = false;
    target_.Until([&] { return player_.position() >= at; }, at + seconds(1));
    held_ = true;
  }
  // Until the screen shows a frame that has sampled the current input. Errors: timed_out.
  Result<void> AwaitFrame(const std::string& scene) {
    const auto now = target_.Board();
    if (!now) return tl::unexpected(now.error());
    // By the guest's clock: a frame that was begun before shows older input.
    const auto drawn = [&](const BoardView& board) { return board.stage.read_ns >= now->now_ns; };
    if (auto ok = target_.UntilBoard(drawn, kLongestFrame, "wait for a frame of scene " + scene); !ok)
      return tl::unexpected(ok.error());
    return {};
  }

 private:
  std::string name_;
  Target& target_;
  Time last_;
  Time start_ = last_;
  Duration played_{};
  bool held_ = false;
  sim::Player player_;
};

// In each scene, when two thirds of it are over: what changes at its beginning has settled by then.
Result<void> ShootScene(Scene& scene, HeldPlay& play, std::size_t beat) {
  const auto& beats = play.scenario().beats;
  const Duration ends = beat + 1 < beats.size() ? beats[beat + 1].at : play.scenario().length;
  play.PlayUntil(beats[beat].at + (ends - beats[beat].at) * 2 / 3);
  if (auto ok = play.AwaitFrame(beats[beat].name); !ok) return ok;
  return scene.ShootFace(play.name(), beats[beat].name);
}

// Plays so many of its scenes, 0 all; gives the number of frames that were drawn meanwhile.
Result<std::uint32_t> PlayFile(Scene& scene, const std::string& file, int most) {
  auto scenario = sim::LoadScenario(file);
  if (!scenario) return tl::unexpected(scenario.error());
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  HeldPlay play(std::move(*scenario), std::filesystem::path(file).stem(), scene.target);
  const std::size_t all = play.scenario().beats.size();
  const std::size_t scenes = most > 0 ? std::min(all, static_cast<std::size_t>(most)) : all;
  for (std::size_t n = 0; n < scenes; ++n)
    if (auto ok = ShootScene(scene, play, n); !ok) return tl::unexpected(ok.error());
  if (scenes == all) play.PlayUntil(play.scenario().length);
  const auto after = scene.target.Board();
  if (!after) return tl::unexpected(after.error());
  return after->stage.frames - before->stage.frames;
}

Result<void> Play(Scene& scene) {
  const auto frames = PlayFile(scene, scene.play, scene.scenes);
  if (!frames) return tl::unexpected(frames.error());
  scene.finding.said = fmt::format("{} scenes, {} frames; time stood still while a slow machine drew",
                                   scene.finding.pictures.size(), *frames);
  return {};
}

// Cables, lens and camera fail in turn; in the end all is there again. The scenario of
// faults lies beside the one of the show.
Result<void> Faults(Scene& scene) {
  const auto file = std::filesystem::path(scene.play).replace_filename("faults.play");
  const auto frames = PlayFile(scene, file, 0);
  if (!frames) return tl::unexpected(frames.error());
  const auto well = [](const BoardView& board) {
    return board.surface_live && board.left.live && board.right.live && board.keys_live &&
           board.pointer_live && board.lips_live && board.lips_quality > 0.5;
  };
  if (auto ok = scene.target.UntilBoard(well, kLongestFrame, "see all devices again"); !ok)
    return tl::unexpected(ok.error());
  scene.finding.said = fmt::format("{} scenes of faults, a face in each; {} frames; all devices are back",
                                   scene.finding.pictures.size(), *frames);
  return {};
}

}  // namespace

std::vector<Check> PlayChecks() {
  return {{"play", "A scenario plays through the box's own drivers", true, Play, {}, "kaori-stage.service"},
          {"faults",
           "A scenario of faults: cables pulled, the lens covered, the camera hung",
           false,
           Faults,
           {},
           "kaori-stage.service"}};
}

}  // namespace kaori::hil
