// How soon the box shows a picture and its face, compared with the usual way of starting such a system.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/picture.h"
#include "hw-sim/hil/process.h"
#include "hw-sim/hil/start_times.h"

namespace kaori::hil {
namespace {

// Medians of three: one start that was disturbed does not count.
constexpr int kRounds = 3;
// Goals, as shares of the usual way's first face.
constexpr double kMostFirstLight = 0.15;
constexpr double kMostFirstFace = 0.35;

const Setup kOurs{.plugged = false, .sound = false, .agent = false, .graphics = Graphics::kVirtio};

// Of an odd number of values, as kRounds is.
double Median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

// Switches on, waits for the first face, and switches off. Errors: those of
// the machine and of AwaitStart.
Result<StartTimes> StartOnce(Scene& scene, const Setup& setup) {
  const Time began = scene.target.clock().now();
  if (auto ok = scene.SwitchOn(setup); !ok) return tl::unexpected(ok.error());
  auto times = AwaitStart(scene.target, began, scene.folder + "/start-shot.png");
  scene.target.machine().Off();
  return times;
}

// Debian's kernel with its modules and one large initramfs that holds the same root without stills and
// shaders, and a processor with everything that QEMU can emulate. Programs and show are the box's own.
Result<Setup> UsualWay(Scene& scene) {
  const QemuOptions& options = scene.target.machine().options();
  const std::string folder = options.folder + "/usual";
  const auto script = std::filesystem::path(options.usual_image);
  if (auto ok = RunToEnd({script, options.image, folder}, scene.folder + "/usual-image.log"); !ok)
    return tl::unexpected(ok.error());
  Setup setup = kOurs;
  setup.stock = true;
  setup.image = folder;
  setup.initramfs = folder + "/initramfs.zst";
  return setup;
}

// Of each round: our times as shares of the usual way's, and all times in seconds.
struct Shares {
  std::vector<double> light, face, light_s, face_s, usual_s;
};

// QEMU's emulation by several threads (MTTCG) now and then lets a kernel run into an instruction that another processor is patching,
// and that kernel panics in an int3, which ends the machine. It was seen with Debian's kernel alone, and says nothing of the time of its start: it is
// started again.
Result<StartTimes> StartUsual(Scene& scene, const Setup& usual) {
  constexpr int kTries = 3;
  for (int n = 1;; ++n) {
    auto times = StartOnce(scene, usual);
    if (times || times.error().cause != std::errc::no_such_device || n == kTries) return times;
  }
}

// Ours and the usual way in turn: the two starts of a round have the same neighbours on this computer.
Result<Shares> Rounds(Scene& scene, const Setup& usual) {
  Shares shares;
  for (int n = 0; n < kRounds; ++n) {
    const auto ours = StartOnce(scene, kOurs), theirs = StartUsual(scene, usual);
    if (!ours || !theirs) return tl::unexpected(ours ? theirs.error() : ours.error());
    shares.light_s.push_back(ours->light_s);
    shares.face_s.push_back(ours->face_s);
    shares.usual_s.push_back(theirs->face_s);
    shares.light.push_back(ours->light_s / theirs->face_s);
    shares.face.push_back(ours->face_s / theirs->face_s);
  }
  return shares;
}

Result<void> StartsSoon(Scene& scene) {
  const auto usual = UsualWay(scene);
  if (!usual) return tl::unexpected(usual.error());
  const auto shares = Rounds(scene, *usual);
  if (!shares) return tl::unexpected(shares.error());
  const double light = Median(shares->light), face = Median(shares->face);
  auto& figures = scene.finding.figures;
  figures["first_light_s"] = Median(shares->light_s);
  figures["first_face_s"] = Median(shares->face_s);
  figures["stock_first_face_s"] = Median(shares->usual_s);
  figures["first_light_over_stock"] = light;
  figures["first_face_over_stock"] = face;
  figures["boot_rounds"] = kRounds;
  scene.finding.said = fmt::format(
      "first picture after {:.1f} s, first face after {:.1f} s, in the usual way after {:.1f} s: {:.3f} (at "
      "most {}) and "
      "{:.3f} (at most {})",
      Median(shares->light_s), Median(shares->face_s), Median(shares->usual_s), light, kMostFirstLight, face,
      kMostFirstFace);
  return MeetsGoals(light, face) ? Result<void>{} : FailInput(scene.finding.said);
}

// The control: a box that starts in the usual way misses both goals. Nothing is started: the goals' own
// function is tried with times that miss one or both.
Result<void> UsualWayIsTooSlow(Scene&) {
  for (const auto& [light, face] : {std::pair{0.151, 0.1}, {0.1, 0.485}, {1.0, 1.0}})
    if (MeetsGoals(light, face)) return FailInput("a start that is too slow passes");
  return {};
}

}  // namespace

bool MeetsGoals(double light_share, double face_share) {
  return light_share <= kMostFirstLight && face_share <= kMostFirstFace;
}

std::vector<Check> StartChecks() {
  return {{"start",
           "The face is there in a third of the usual time",
           false,
           StartsSoon,
           kOurs,
           {},
           UsualWayIsTooSlow,
           true}};
}

}  // namespace kaori::hil
