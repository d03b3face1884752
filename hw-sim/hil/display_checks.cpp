// The screens that a box may find, and what is on its screen from power to the face.
#include <filesystem>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/picture.h"

namespace kaori::hil {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Duration kLongestDisplayStart = seconds(600);
constexpr Duration kLongestDisplay = seconds(180);
constexpr Duration kQuiet = seconds(20);      // For so long nothing may change for the worse.
constexpr Duration kAfterFace = seconds(10);  // For so long the screen is looked at after the first face.
constexpr double kSameFace = 0.06;            // As far as a face moves by itself.
constexpr int kWidth_px = 320, kHeight_px = 240;
// In systemd's own words.
constexpr const char* kStageEnded = "kaori-stage.service: Main process exited";

// The machines of these checks. Screens are small, since the guest draws by its processor, which is emulated;
// nothing is plugged in that a check does not need.
const Setup kSilentScreen{.plugged = false,
                          .sound = false,
                          .graphics = Graphics::kVirtio,
                          .tells_size = false,
                          .width_px = kWidth_px,
                          .height_px = kHeight_px};
const Setup kOddScreen{
    .plugged = false, .sound = false, .graphics = Graphics::kVirtio, .width_px = 72, .height_px = 900};
const Setup kBusyMachine{.plugged = false,
                         .sound = false,
                         .graphics = Graphics::kVirtio,
                         .width_px = kWidth_px,
                         .height_px = kHeight_px};
const Setup kNoCard{.plugged = false, .sound = false, .agent = false, .graphics = Graphics::kNone};
const Setup kLateScreen{.plugged = false,
                        .sound = false,
                        .agent = false,
                        .graphics = Graphics::kVirtio,
                        .screens = 1,
                        .width_px = kWidth_px,
                        .height_px = kHeight_px};
const Setup kHandover{.plugged = false,
                      .sound = false,
                      .agent = false,
                      .graphics = Graphics::kVirtio,
                      .width_px = 480,
                      .height_px = 270};

// Whatever the screen tells of itself, or does not: the box chooses a mode, and her face moves in it.
Result<void> MovingFace(Scene& scene) {
  if (auto ok = scene.AwaitMovingFace(0, kLongestDisplay); !ok) return ok;
  scene.finding.said = "a face that moves";
  return scene.ShootFace("display", "The face");
}

// The machine's time is taken away, not its clock: frames are slow, and no hang.
Result<void> BusyMachine(Scene& scene) {
  // A minute, of which a virtual processor has a quarter.
  constexpr int kTimes = 30;
  constexpr Duration kTaken = milliseconds(1500), kLeft = milliseconds(500);
  if (auto ok = scene.AwaitMovingFace(0, kLongestDisplay); !ok) return ok;
  for (int n = 0; n < kTimes; ++n) {
    scene.target.machine().Freeze(true);
    scene.target.For(kTaken);
    scene.target.machine().Freeze(false);
    scene.target.For(kLeft);
  }
  if (auto ok = scene.AwaitMovingFace(0, kLongestDisplay); !ok) return ok;
  scene.finding.said = "three quarters of its time were taken away for a minute; the stage was left alone";
  return scene.WantNoRestart();
}

// The service manager says on the console when the stage has ended, for whatever reason.
bool HasEnded(Scene& scene) {
  return scene.target.UntilConsole({kStageEnded}, Duration::zero());
}

// The stage says so also where no screen shows it.
Result<void> AwaitFirstPicture(Scene& scene) {
  if (scene.target.UntilFirstPicture(kLongestDisplayStart)) return {};
  return Fail(std::errc::timed_out, "wait for the first picture");
}

// The machine has no agent: what the stage says on the console is all that is known of it. A stage that ended would be
// started again, and again, which the console says as well.
Result<void> PlayUnseen(Scene& scene, const Setup& setup) {
  if (auto ok = scene.SwitchOn(setup); !ok) return ok;
  if (auto ok = AwaitFirstPicture(scene); !ok) return ok;
  if (!scene.target.UntilConsole({"there is no graphics card"}, Duration::zero()))
    return FailInput("the log does not name the missing graphics card");
  scene.target.For(kQuiet);
  scene.finding.said = "the log names the missing card; the stage plays on unseen";
  return HasEnded(scene) ? FailInput("the stage ended without a graphics card") : Result<void>{};
}

// The machine goes off whatever was found: the next check starts its own.
Result<void> WithoutCard(Scene& scene) {
  auto ok = PlayUnseen(scene, kNoCard);
  scene.target.machine().Off();
  return ok;
}

// The control: with a card nothing of that is said.
Result<void> CardIsNotMissed(Scene& scene) {
  const auto missed = PlayUnseen(scene, kHandover);
  scene.target.machine().Off();
  return WantFoundWrong(missed, "a graphics card is said to be missing where there is one");
}

// The screen is unplugged before the stage starts, and plugged in again when it plays.
Result<void> PlayWithLateScreen(Scene& scene, bool comes) {
  QemuDriver& machine = scene.target.machine();
  if (auto ok = scene.SwitchOn(kLateScreen); !ok) return ok;
  // QEMU unplugs only what its viewer has plugged in.
  if (auto ok = machine.PlugScreen(0, kWidth_px, kHeight_px); !ok) return ok;
  scene.target.For(milliseconds(1500));
  if (auto ok = machine.PlugScreen(0, 0, 0); !ok) return ok;
  if (auto ok = AwaitFirstPicture(scene); !ok) return ok;
  if (scene.target.UntilConsole({"a screen is plugged in"}, Duration::zero()))
    return FailInput("the stage finds a screen where there is none");
  if (comes)
    if (auto ok = machine.PlugScreen(0, kWidth_px, kHeight_px); !ok) return ok;
  if (auto ok = scene.AwaitMovingFace(0, kLongestDisplay); !ok) return ok;
  if (auto ok = scene.ShootFace("late", "On the screen that came late"); !ok) return ok;
  const auto picture = LookAt(scene.folder + "/" + scene.finding.pictures.back().file);
  if (!picture) return tl::unexpected(picture.error());
  scene.finding.said = Describe(*picture);
  if (picture->width_px != kWidth_px || picture->height_px != kHeight_px)
    return FailInput(scene.finding.said);
  return HasEnded(scene) ? FailInput("the stage started again for a screen") : Result<void>{};
}

// The machine goes off in each case: what is plugged in here is in no other check.
Result<void> LateScreen(Scene& scene) {
  auto ok = PlayWithLateScreen(scene, true);
  scene.target.machine().Off();
  return ok;
}

// The control: on a screen that never comes no face is seen.
Result<void> ScreenNeverComes(Scene& scene) {
  scene.target.SetPatience(seconds(20));
  const bool seen = PlayWithLateScreen(scene, false).has_value();
  scene.target.ResetPatience();
  scene.target.machine().Off();
  return seen ? FailInput("a face is seen although no screen is plugged in") : Result<void>{};
}

// Looks at one picture after another. Before the first one with a face the screen is dark, or shows what QEMU
// writes on one that nobody has lit; then the still; then the face, which differs little from it. Nothing
// else, ever.
class HandoverWatch {
 public:
  explicit HandoverWatch(std::string folder) : folder_(std::move(folder)) {}

  std::string now() const { return folder_ + "/handover-now.png"; }
  std::string still() const { return folder_ + "/handover-still.png"; }

  Result<void> Look() {
    const auto picture = LookAt(now());
    if (!picture) return tl::unexpected(picture.error());
    ++looks_;
    if (looks_ == 1) Keep(unlit());
    if (!lit_ && ShowsAFace(*picture)) Keep(still()), lit_ = true;
    return lit_ ? LookForOthers() : LookForDark(*picture);
  }

  // Wants that those that differ from the still look like the last one.
  Result<int> CountWrong() const {
    int wrong = early_;
    for (int n = 0; n < others_; ++n) {
      const auto apart = MeanDifference(other(n), now());
      if (!apart) return tl::unexpected(apart.error());
      wrong += *apart >= kSameFace ? 1 : 0;
    }
    return wrong;
  }
  int looks() const { return looks_; }
  bool lit() const { return lit_; }

 private:
  std::string unlit() const { return folder_ + "/handover-unlit.png"; }
  std::string other(int n) const { return fmt::format("{}/handover-other-{}.png", folder_, n); }
  void Keep(const std::string& file) const {
    std::filesystem::copy_file(now(), file, std::filesystem::copy_options::overwrite_existing);
  }

  Result<void> LookForDark(const PictureView& picture) {
    constexpr int kFlat = 2;  // A picture of so few colours is one of none.
    const auto changed = ChangedPart(now(), unlit());
    if (!changed) return tl::unexpected(changed.error());
    early_ += *changed > 0 && picture.colours > kFlat ? 1 : 0;
    return {};
  }

  Result<void> LookForOthers() {
    const auto apart = MeanDifference(now(), still());
    if (!apart) return tl::unexpected(apart.error());
    if (*apart >= kSameFace) Keep(other(others_++));
    return {};
  }

  std::string folder_;
  int looks_ = 0, early_ = 0, others_ = 0;
  bool lit_ = false;
};

// Pictures back to back, as fast as QEMU gives them, from power until some time after the stage was started.
// That nothing came at all is a failure: nothing wrong would be seen then either.
Result<void> WatchHandover(Scene& scene, HandoverWatch& watch) {
  Time ends = scene.target.clock().now() + kLongestDisplayStart;
  for (bool played = false; scene.target.clock().now() < ends;) {
    auto ok = scene.target.machine().Shoot(0, watch.now());
    if (ok) ok = watch.Look();
    if (!ok) return ok;
    const bool plays = scene.target.UntilFirstPicture(Duration::zero());
    if (plays && !played) ends = scene.target.clock().now() + kAfterFace;
    played |= plays;
  }
  return watch.lit() ? Result<void>{} : FailInput("no picture came");
}

Result<void> Handover(Scene& scene) {
  HandoverWatch watch(scene.folder);
  auto ok = scene.SwitchOn(kHandover);
  if (ok) ok = WatchHandover(scene, watch);
  if (ok) ok = scene.ShootFace("handover", "The face at the end");
  scene.target.machine().Off();
  if (!ok) return ok;
  const auto wrong = watch.CountWrong();
  if (!wrong) return tl::unexpected(wrong.error());
  scene.finding.figures["handover_pictures"] = watch.looks();
  scene.finding.figures["handover_wrong"] = *wrong;
  scene.finding.said =
      fmt::format("{} pictures from power to the face, {} of them neither dark nor still nor face",
                  watch.looks(), *wrong);
  return *wrong == 0 ? Result<void>{} : FailInput(scene.finding.said);
}

// The control: one black picture between still and face is found.
Result<void> BlackIsFound(Scene& scene) {
  const std::string still = std::filesystem::path(scene.folder).parent_path() / "handover-still.png";
  HandoverWatch watch(scene.folder);
  for (const bool black : {false, true, false}) {
    std::filesystem::copy_file(still, watch.now(), std::filesystem::copy_options::overwrite_existing);
    if (black)
      if (auto ok = WriteBlack(still, watch.now()); !ok) return ok;
    if (auto ok = watch.Look(); !ok) return ok;
  }
  const auto wrong = watch.CountWrong();
  return wrong && *wrong == 1 ? Result<void>{} : FailInput("a black picture is not found");
}

}  // namespace

// Those that fail without the stage have it stopped as their control; the others bring a control of their
// own.
std::vector<Check> DisplayChecks() {
  constexpr const char* kStage = "kaori-stage.service";
  return {{"silent-screen", "A screen that says nothing of itself shows the face", false, MovingFace,
           kSilentScreen, kStage},
          {"odd-screen", "A screen of an odd size shows the face", false, MovingFace, kOddScreen, kStage},
          {"busy-machine", "A machine that lacks time is slow, and nothing is taken for a hang", false,
           BusyMachine, kBusyMachine, kStage},
          {"no-card",
           "Without a graphics card the stage plays on unseen",
           false,
           WithoutCard,
           kNoCard,
           {},
           CardIsNotMissed,
           true},
          {"late-screen",
           "The face comes to a screen that is plugged in late",
           false,
           LateScreen,
           kLateScreen,
           {},
           ScreenNeverComes,
           true},
          {"handover",
           "From power to the face the screen shows the still and nothing else",
           false,
           Handover,
           kHandover,
           {},
           BlackIsFound,
           true}};
}

}  // namespace kaori::hil
