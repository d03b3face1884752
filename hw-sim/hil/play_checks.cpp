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
// Until a device that is pulled or plugged in is missed or found.
constexpr Duration kLongestCable = seconds(90);
constexpr std::uint8_t kOpeningKey = 0x3A;  // F1, which calls the default show's first scene (HID page 7).
// Closer together no two actions of a scenario are.
constexpr Duration kJustBefore = std::chrono::milliseconds(1);

// Brings everything back that a scenario may leave otherwise, also where it ends before its time: what a check or its control leaves
// unplugged, held or covered would be missing in the next one.
class RigComesBack {
 public:
  explicit RigComesBack(Target& target) : target_(target) {}
  ~RigComesBack() {
    sim::InputDevices& devices = target_.rig().devices();
    static_cast<void>(target_.PlugAll());
    for (sim::StickPod* stick : {&devices.left_stick, &devices.right_stick}) LetGo(*stick);
    for (int button = 0; button < kButtons; ++button) devices.dial_box.Release(button);
    for (int button = 0; button < kPointerButtons; ++button) devices.pointer.Release(button);
    for (int usage = 0; usage <= kLastKey; ++usage)
      devices.keyboard.Release(static_cast<std::uint8_t>(usage));
    devices.camera.CoverLens(false);
    devices.camera.Stall(false);
    devices.camera.SetMouth(0.25, 1);
  }
  RigComesBack(const RigComesBack&) = delete;
  RigComesBack& operator=(const RigComesBack&) = delete;

 private:
  // Of the simulated devices; the keyboard's usages end with the modifiers. What is not held is left alone.
  static constexpr int kButtons = 32, kPointerButtons = 3, kStickButtons = 12, kLastKey = 0xE7;

  static void LetGo(sim::StickPod& stick) {
    stick.Move(0, 0);
    stick.Twist(0);
    stick.Hat(-1);
    for (int button = 0; button < kStickButtons; ++button) stick.Release(button);
  }

  Target& target_;
};

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
      // The time since the last call counts only up to where the play is held: a busy computer calls late.
      if (now > last_) played_ = std::min(played_ + (now - last_), held_at_);
      last_ = now;
      player_.Perform(start_ + played_);
    });
  }
  ~HeldPlay() { target_.SetInput({}); }
  HeldPlay(const HeldPlay&) = delete;
  HeldPlay& operator=(const HeldPlay&) = delete;

  const std::string& name() const { return name_; }  // Of its pictures.
  const sim::Scenario& scenario() const { return player_.scenario(); }
  Duration position() const { return player_.position(); }
  // Plays up to exactly this time of the scenario, and holds it there. Blocks for as long as that takes.
  void PlayUntil(Duration at) {
    held_at_ = std::max(at, held_at_);
    target_.Until([&] { return player_.position() >= at; }, at + kLongestFrame);
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
  // Where it stands still.
  Duration held_at_{};
  sim::Player player_;
};

// What is wanted of a play beside a face in each of its scenes.
struct PlayWants {
  // Something of its input has arrived in each scene.
  bool input = false;
  // Each device that is pulled was there, and is missed before it is plugged in again.
  bool cables = false;
};

// Whether the box finds the device at this port, as far as its board tells. Pure.
bool IsThere(const BoardView& board, sim::DevicePort port) {
  switch (port) {
    case sim::DevicePort::kDialBox:
      return board.surface_live;
    case sim::DevicePort::kStickLeft:
      return board.left.live;
    case sim::DevicePort::kStickRight:
      return board.right.live;
    case sim::DevicePort::kKeyboard:
      return board.keys_live;
    case sim::DevicePort::kPointer:
      return board.pointer_live;
    case sim::DevicePort::kCamera:
      return board.lips_live;
    default:
      return false;
  }
}

// The play stands still meanwhile, however long the box takes.
Result<void> WantCable(Scene& scene, sim::DevicePort port, bool there) {
  const auto stands = [&](const BoardView& board) { return IsThere(board, port) == there; };
  const auto seen = scene.target.UntilBoard(
      stands, kLongestCable, fmt::format("see the {} {}", sim::PortName(port), there ? "there" : "gone"));
  if (!seen) return tl::unexpected(seen.error());
  return {};
}

// Plays up to that time. Where cables are wanted it stops right before each that is pulled or plugged in: the device must be there
// until then, or be missed.
Result<void> PlayOn(Scene& scene, HeldPlay& play, Duration at, const PlayWants& wants) {
  for (const sim::TimedAction& timed : play.scenario().actions) {
    const bool pulls = timed.action.verb == sim::Verb::kUnplug;
    const bool is_cable = pulls || timed.action.verb == sim::Verb::kPlug;
    if (!wants.cables || !is_cable || timed.at <= play.position() || timed.at > at) continue;
    play.PlayUntil(timed.at - kJustBefore);
    if (auto ok = WantCable(scene, timed.action.port, pulls); !ok) return ok;
  }
  play.PlayUntil(at);
  return {};
}

// In each scene, when two thirds of it are over: what changes at its beginning has settled by then.
Result<void> ShootScene(Scene& scene, HeldPlay& play, std::size_t beat, const PlayWants& wants) {
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  const auto& beats = play.scenario().beats;
  const Duration ends = beat + 1 < beats.size() ? beats[beat + 1].at : play.scenario().length;
  if (auto ok = PlayOn(scene, play, beats[beat].at + (ends - beats[beat].at) * 2 / 3, wants); !ok) return ok;
  if (auto ok = play.AwaitFrame(beats[beat].name); !ok) return ok;
  const auto after = scene.target.Board();
  if (!after) return tl::unexpected(after.error());
  if (wants.input && after->newest_input_ns <= before->newest_input_ns)
    return FailInput(fmt::format("no input of scene {} has arrived", beats[beat].name));
  return scene.ShootFace(play.name(), beats[beat].name);
}

// Plays so many of its scenes, 0 all; gives the number of frames that were drawn meanwhile. A mark at the very end is no scene:
// the play's own stands behind the curtain.
Result<std::uint32_t> PlayFile(Scene& scene, const std::string& file, int most, const PlayWants& wants) {
  auto scenario = sim::LoadScenario(file);
  if (!scenario) return tl::unexpected(scenario.error());
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  // Its end comes after that of the play, which moves things until then.
  const RigComesBack comes_back(scene.target);
  HeldPlay play(std::move(*scenario), std::filesystem::path(file).stem(), scene.target);
  const auto& beats = play.scenario().beats;
  const bool has_end_mark = !beats.empty() && beats.back().at == play.scenario().length;
  const std::size_t all = beats.size() - (has_end_mark ? 1 : 0);
  const std::size_t scenes = most > 0 ? std::min(all, static_cast<std::size_t>(most)) : all;
  for (std::size_t n = 0; n < scenes; ++n)
    if (auto ok = ShootScene(scene, play, n, wants); !ok) return tl::unexpected(ok.error());
  if (scenes == all)
    if (auto ok = PlayOn(scene, play, play.scenario().length, wants); !ok) return tl::unexpected(ok.error());
  const auto after = scene.target.Board();
  if (!after) return tl::unexpected(after.error());
  return after->stage.frames - before->stage.frames;
}

// All of the show's own scenario, or its first scenes.
Result<void> Play(Scene& scene) {
  const auto frames = PlayFile(scene, scene.play, scene.scenes, {.input = true});
  if (!frames) return tl::unexpected(frames.error());
  scene.TapKey(kOpeningKey);  // The play ends with the curtain.
  scene.finding.said =
      fmt::format("{} scenes, input in each, {} frames; time stood still while a slow machine drew",
                  scene.finding.pictures.size(), *frames);
  return {};
}

// Cables, lens and camera fail in turn; in the end all is there again. The scenario of
// faults lies beside the one of the show.
Result<void> Faults(Scene& scene) {
  const auto file = std::filesystem::path(scene.play).replace_filename("faults.play");
  const auto frames = PlayFile(scene, file, 0, {.cables = true});
  if (!frames) return tl::unexpected(frames.error());
  const auto well = [](const BoardView& board) {
    return board.surface_live && board.left.live && board.right.live && board.keys_live &&
           board.pointer_live && board.lips_live && board.lips_quality > 0.5;
  };
  if (auto ok = scene.target.UntilBoard(well, kLongestFrame, "see all devices again"); !ok)
    return tl::unexpected(ok.error());
  scene.finding.said =
      fmt::format("{} scenes of faults, a face in each; {} frames; what was pulled was missed, and is back",
                  scene.finding.pictures.size(), *frames);
  return {};
}

}  // namespace

std::vector<Check> PlayChecks() {
  return {{"play", "A scenario plays through the box's own drivers", true, Play, {}, "kaori-input.service"},
          {"faults",
           "A scenario of faults: cables pulled, the lens covered, the camera hung",
           false,
           Faults,
           {},
           "kaori-stage.service"}};
}

}  // namespace kaori::hil
