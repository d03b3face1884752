// Screens that are plugged in and unplugged while the face plays, and the one that shows the box's status.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/picture.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

constexpr Duration kLongestPicture = seconds(180);
constexpr int kTurns = 20;
constexpr Duration kLeftAlone = seconds(1);  // Before the next screen is plugged in or unplugged.
constexpr Duration kStatusSettles = seconds(10);
constexpr double kFaceStays = 0.06;  // As far as a face moves by itself.
// The marks of what is missing and of what is there.
constexpr std::array<int, 3> kAmber{235, 170, 50}, kGreen{70, 190, 110};

struct ScreenSize {
  int width_px = 0, height_px = 0;
};
// The two show screens differ in size, so that a picture says which of them it is of.
constexpr std::array<ScreenSize, 2> kSizes{{{320, 240}, {400, 300}}};
constexpr ScreenSize kStatusSize{640, 480};

const Setup kTwoScreens{.plugged = false,
                        .sound = false,
                        .graphics = Graphics::kVirtio,
                        .screens = 2,
                        .width_px = 320,
                        .height_px = 240};
const Setup kStatusScreen{.plugged = false,
                          .sound = false,
                          .graphics = Graphics::kVirtio,
                          .screens = 2,
                          .width_px = 320,
                          .height_px = 240,
                          .settings = "profile = \"bench\"\nstatus_screen = \"Virtual-2\"\n"};

// By the size that a viewer of that output asks for: QEMU then plugs a screen of it in.
Result<void> PlugOutput(Scene& scene, int head, const ScreenSize& size) {
  return scene.target.machine().PlugScreen(head, size.width_px, size.height_px);
}

// The machine's two screens; what must be true of them is looked at after each change.
class Outputs {
 public:
  explicit Outputs(Scene& scene) : scene_(scene) {}

  // Plugs the screen in, or unplugs it.
  Result<void> Turn(std::size_t head) {
    plugged_[head] = !plugged_[head];
    auto ok = PlugOutput(scene_, static_cast<int>(head), plugged_[head] ? kSizes[head] : ScreenSize{});
    if (!plugged_[head]) scene_.target.For(kLeftAlone);
    for (std::size_t n = 0; ok && n < plugged_.size(); ++n)
      if (plugged_[n]) ok = AwaitFace(n);
    return ok;
  }
  double longest_s() const { return longest_s_; }

 private:
  Result<void> AwaitFace(std::size_t head) {
    const Time began = scene_.target.clock().now();
    const std::string file = scene_.folder + "/output.png";
    const auto sized = [&] {
      const auto shot = scene_.target.machine().Shoot(static_cast<int>(head), file);
      const auto picture = shot.and_then([&] { return LookAt(file); });
      return picture && picture->width_px == kSizes[head].width_px &&
             picture->height_px == kSizes[head].height_px;
    };
    auto ok = scene_.target.Await(sized, kLongestPicture, fmt::format("see screen {} in its size", head + 1));
    if (ok) ok = scene_.AwaitMovingFace(static_cast<int>(head), kLongestPicture);
    longest_s_ = std::max(longest_s_, Seconds(scene_.target.clock().now() - began));
    return ok;
  }

  Scene& scene_;
  std::array<bool, 2> plugged_{true, false};
  double longest_s_ = 0;
};

// With two screens the face spans both; with one it plays there; with none the stage waits.
Result<void> PlugOutputs(Scene& scene) {
  Outputs outputs(scene);
  for (int n = 0; n < kTurns; ++n)
    if (auto ok = outputs.Turn(n == 0 ? 1 : std::uniform_int_distribution<std::size_t>(0, 1)(scene.chance));
        !ok)
      return FailAs(ok.error(), fmt::format("change {}: {}", n + 1, ok.error().attempt));
  scene.finding.figures["output_turns"] = kTurns;
  scene.finding.figures["output_longest_s"] = outputs.longest_s();
  scene.finding.said =
      fmt::format("{} times a screen was plugged in or unplugged; a moving face after {:.1f} s at most",
                  kTurns, outputs.longest_s());
  return scene.WantNoRestart();
}

// The show's screen, and that of the status display.
constexpr int kShowHead = 0, kStatusHead = 1;

// Of a status display.
struct Marks {
  int missing = 0, there = 0;
};

// A status is read from its colours on a screen: amber marks are what is missing, green ones what is there.
Result<Marks> CountStatus(Scene& scene, int head) {
  const std::string file = scene.folder + "/status-now.png";
  if (auto ok = scene.target.machine().Shoot(head, file); !ok) return tl::unexpected(ok.error());
  const auto amber = CountMarks(file, kAmber), green = CountMarks(file, kGreen);
  if (!amber || !green) return tl::unexpected(amber ? green.error() : amber.error());
  return Marks{*amber, *green};
}

// Errors: invalid_argument, the screen shows marks of a status.
Result<void> WantNoStatus(Scene& scene, int head) {
  const auto marks = CountStatus(scene, head);
  if (!marks) return tl::unexpected(marks.error());
  if (marks->missing + marks->there == 0) return {};
  return FailInput(
      fmt::format("screen {} shows {} marks of a status", head + 1, marks->missing + marks->there));
}

// The show's screen has none; the one with the status is found to have some by the same look.
Result<void> WantStatusOnItsOwnScreen(Scene& scene) {
  if (auto ok = WantNoStatus(scene, kShowHead); !ok) return ok;
  return WantFoundWrong(WantNoStatus(scene, kStatusHead), "marks of the status are not seen where it is");
}

// The status is drawn a part of it in each frame, so that a picture in between is not what it will be: it is looked at
// again until it is right. Errors: timed_out, with `what` was awaited.
Result<void> AwaitStatus(Scene& scene, const std::function<bool(const Marks&)>& right, const char* what) {
  const auto seen = [&] {
    const auto marks = CountStatus(scene, kStatusHead);
    return marks && right(*marks);
  };
  return scene.target.Await(seen, kLongestPicture, what);
}

// The status first: of the two it is the one that is about to change.
Result<void> ShootBoth(Scene& scene, const char* when) {
  for (int head = 1; head >= 0; --head) {
    const std::string file = fmt::format("status-{}.png", scene.finding.pictures.size());
    if (auto ok = scene.target.machine().Shoot(head, scene.folder + "/" + file); !ok) return ok;
    scene.finding.pictures.push_back({file, fmt::format("Screen {}, {}", head + 1, when)});
  }
  return {};
}

// The keyboard is unplugged: the second screen says so, and the show's own does not.
Result<void> UnplugKeyboard(Scene& scene) {
  if (auto ok = WantStatusOnItsOwnScreen(scene); !ok) return ok;
  const auto before = CountStatus(scene, kStatusHead);
  if (!before) return tl::unexpected(before.error());
  if (auto ok = ShootBoth(scene, "with a keyboard"); !ok) return ok;
  const Time unplugged = scene.target.clock().now();
  static_cast<void>(scene.target.rig().Unplug("keyboard"));
  const auto gone = [&](const Marks& marks) {
    return marks.there < before->there && marks.missing > before->missing;
  };
  if (auto ok = AwaitStatus(scene, gone, "see that the keyboard is said to be gone"); !ok) return ok;
  const double said_s = Seconds(scene.target.clock().now() - unplugged);
  scene.finding.figures["status_says_s"] = said_s;
  if (auto ok = WantStatusOnItsOwnScreen(scene); !ok) return ok;
  if (auto ok = ShootBoth(scene, "without it"); !ok) return ok;
  const auto& pictures = scene.finding.pictures;
  const auto apart =
      MeanDifference(scene.folder + "/" + pictures[1].file, scene.folder + "/" + pictures[3].file);
  if (!apart) return tl::unexpected(apart.error());
  scene.finding.said = fmt::format(
      "an unplugged keyboard is named after {:.1f} s; the show's screen has no mark of the status, and "
      "changed by {:.3f} (at most {})",
      said_s, *apart, kFaceStays);
  return *apart < kFaceStays ? Result<void>{} : FailInput(scene.finding.said);
}

// The second screen comes once the first one plays. Linux's driver of the simulated card (virtio-gpu) forgets
// a change that comes while it handles the one before: it clears the event of both.
Result<void> ShowStatus(Scene& scene) {
  constexpr int kMissing = 6, kThere = 4;  // At least: a show, two screens and a keyboard are there.
  if (auto ok = scene.target.rig().Plug("keyboard"); !ok) return ok;
  auto ok = PlugOutput(scene, 0, kSizes[0]);
  if (ok) ok = scene.AwaitMovingFace(0, kLongestPicture);
  if (ok) ok = PlugOutput(scene, 1, kStatusSize);
  const auto complete = [](const Marks& marks) { return marks.missing >= kMissing && marks.there >= kThere; };
  if (ok) ok = AwaitStatus(scene, complete, "see the status name what is missing and what is there");
  if (ok) scene.target.For(kStatusSettles);
  if (ok) ok = UnplugKeyboard(scene);
  return ok ? scene.AwaitMovingFace(0, kLongestPicture) : ok;
}

}  // namespace

std::vector<Check> OutputChecks() {
  return {{"outputs", "Screens are plugged in and unplugged while the face plays", false, PlugOutputs,
           kTwoScreens, "kaori-stage.service"},
          {"status-screen", "A second screen shows the box's status, and the show's screen shows none of it",
           false, ShowStatus, kStatusScreen, "kaori-stage.service"}};
}

}  // namespace kaori::hil
