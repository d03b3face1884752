// A company's own show comes by a stick while the service key is on; without the key a stick is unauthorised.
#include <algorithm>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/process.h"
#include "hw-sim/hil/stick_scene.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

constexpr std::size_t kLargestSupport_bytes = std::size_t{8} << 20U;  // More than the box writes.
// Long enough for some dozens of frames of a machine whose processor draws.
constexpr Duration kRateSpan = seconds(60);
// Of the face's rate before, that it keeps meanwhile.
constexpr double kLeastRate = 0.95;

// How many frames a second the stage presents, between two looks at the board; 0 where they do not tell. From the sampling of one
// frame to that of another: of the looks themselves each would be off by up to a frame.
double Rate(const Result<BoardView>& from, const Result<BoardView>& to) {
  if (!from || !to || to->stage.read_ns <= from->stage.read_ns || to->stage.frames < from->stage.frames)
    return 0;
  return 1e9 * (to->stage.frames - from->stage.frames) /
         static_cast<double>(to->stage.read_ns - from->stage.read_ns);
}

// What the first line of a stick's list does, and by which names it is measured.
struct Bringing {
  // Said once its key was pressed, and when it is done.
  std::string_view begins, done;
  // Figures: the face's rate meanwhile, of that before; how long it took.
  const char* rate;
  const char* took_s;
};
constexpr Bringing kShow{"guest: it ", "it is on the box and plays now", "install_under_play_rate",
                         "install_s"};
constexpr Bringing kUpdate{": it is being ", "it is on the box and waits", "face_rate_while_installing",
                           "update_under_play_s"};

// Until it is on the box. With another show the stage ends and another one counts on: what the first one counted last is the end of
// the span. The box is asked as often before the installation as during it, since its answers cost an emulated machine more than the
// installation does.
// Errors: invalid_argument, it is not installed, or the face did not keep its rate.
Result<void> InstallUnderPlay(Scene& scene, const Bringing& what) {
  constexpr const char* kStage = "processes kaori-stage";
  const std::string stage = TextInBox(scene, kStage);
  const auto first = scene.target.Board();
  auto last = first;
  std::string said;
  const auto is_done = [&] { return said.find(what.done) != std::string::npos; };
  const auto ask = [&] {
    // No answer is nothing new.
    if (std::string heard = TextInBox(scene, kSaid); !heard.empty()) said = std::move(heard);
    auto board = scene.target.Board();
    // Asked behind the look: while the first stage runs nobody else has counted.
    if (board && TextInBox(scene, kStage) == stage) last = std::move(board);
    return is_done();
  };
  static_cast<void>(scene.target.Until(ask, kRateSpan));
  const auto began = last;
  if (auto ok = PressFor(scene, kOne, what.begins); !ok) return ok;
  const auto look = [&] {
    ask();
    return said;
  };
  const auto right = [&](const std::string&) { return is_done(); };
  if (auto ok = UntilSaid(scene, right, look); !ok) return ok;
  const double before = Rate(first, began), during = Rate(began, last);
  if (before <= 0 || during <= 0)
    return FailInput(fmt::format("the face's rate is not known: {:.2f} and {:.2f} frames/s", before, during));
  const double kept = during / before;
  scene.finding.figures[what.rate] = kept;
  scene.finding.figures[what.took_s] = 1e-9 * static_cast<double>(last->now_ns - began->now_ns);
  if (kept >= kLeastRate) return {};
  return FailInput(fmt::format("the face keeps {:.2f} of its rate meanwhile, and not {}", kept, kLeastRate));
}

// The key of whoever signed it, then the show.
Result<void> BringShow(Scene& scene) {
  if (auto ok = BringKey(scene, "guest"); !ok) return ok;
  return InstallUnderPlay(scene, kShow);
}

// Another show of the same theatre, with some bytes changed: it is copied, and refused; what plays goes on.
Result<void> WantDamagedRefused(Scene& scene, const std::string& id) {
  if (auto ok = scene.target.machine().PullUnauthorised(); !ok) return ok;
  if (auto ok = Plug(scene, "damaged.stick"); !ok) return ok;
  if (auto ok = WantStickSaid(scene, "> 1. matinee  ", kLongestReading); !ok) return ok;
  if (auto ok = PressFor(scene, kOne, "matinee: it "); !ok) return ok;
  if (auto ok = WantStickSaid(scene, "matinee: it is damaged", kLongestInstalling); !ok) return ok;
  const auto chosen = ChosenId(scene);
  if (!chosen) return tl::unexpected(chosen.error());
  if (*chosen != id) return FailInput("the damaged show is chosen");
  return WantPlayed(scene, id);
}

// The support file, onto a stick that holds nothing; the copy of the stick is what this computer then reads, as a
// technician does.
Result<void> WantSupportFile(Scene& scene) {
  constexpr std::string_view kLine = "support file for a technician";
  const std::string read = scene.folder + "/support";
  const auto plugged = PlugEmptyStick(scene, "support");
  if (!plugged) return tl::unexpected(plugged.error());
  const std::string& stick = *plugged;
  constexpr std::string_view kWritten = "it is on the stick, for a technician";
  if (auto ok = ChooseLine(scene, kLine, kWritten, minutes(3)); !ok) return ok;
  if (auto ok = scene.target.machine().PullUnauthorised(); !ok) return ok;
  std::filesystem::remove_all(read);
  std::filesystem::create_directories(read);
  if (auto ok = RunToEnd({"mcopy", "-i", stick, "::/kaori-*.txt", read}, scene.folder + "/mcopy.log"); !ok)
    return tl::unexpected(ok.error());
  for (const auto& file : std::filesystem::directory_iterator(read)) {
    const std::string text = ReadFile(file.path(), {.most_bytes = kLargestSupport_bytes}).value_or("");
    for (const std::string_view part :
         {"Support file of the box kaori-", "Why the last starts ended", "== Journal =="})
      if (text.find(part) == std::string::npos)
        return FailInput(fmt::format("the support file has no \"{}\"", part));
    scene.finding.figures["support_file_kb"] = static_cast<double>(text.size()) * 1e-3;
    return {};
  }
  return FailInput("there is no support file on the stick");
}

// The key is turned off in each case, since the next check finds the bridge as it was left.
Result<std::string> BringBoth(Scene& scene) {
  scene.target.rig().gpio().Close(kStickKey);
  Result<std::string> id;
  auto ok = BringShow(scene);
  if (ok) id = ChosenId(scene);
  if (ok && !id) ok = tl::unexpected(id.error());
  if (ok) ok = WantPlayed(scene, *id);
  if (ok) ok = WantDamagedRefused(scene, *id);
  if (ok) ok = WantSupportFile(scene);
  // A stick that is seen while the key is on, so that it can be seen to die with it.
  if (ok) ok = Plug(scene, "damaged.stick");
  if (ok) ok = WantStickSaid(scene, "> 1. matinee  ", kLongestReading);
  scene.target.rig().gpio().Open(kStickKey);
  if (ok) ok = WantDead(scene);
  if (ok) ok = scene.ShootFace("stick", "A company's own show, which a stick brought");
  static_cast<void>(scene.target.machine().PullUnauthorised());
  if (!ok) return tl::unexpected(ok.error());
  return id;
}

// Two starts of one disk, which is a copy and removed in each case. The second start shows what was really
// kept: memory, in which the stage is told of a choice, is gone with the power.
Result<void> BringsAShow(Scene& scene) {
  const QemuOptions& options = scene.target.machine().options();
  const auto disk = CopyDisk(options.image + "/kaori.disk", options.folder, "brought.disk", "data");
  if (!disk) return tl::unexpected(disk.error());
  PlayStrategy box(scene.target);
  auto ok = box.Play(StickSetup(disk->file));
  const auto id = ok ? BringBoth(scene) : Result<std::string>(tl::unexpected(ok.error()));
  if (!id) ok = tl::unexpected(id.error());
  if (ok) box.Off();
  // It is what plays when the power is back.
  if (ok) ok = box.Play(StickSetup(disk->file));
  if (ok) ok = WantPlayed(scene, *id);
  if (ok) box.Off();
  std::filesystem::remove(disk->file);
  scene.finding.said = fmt::format(
      "a show and its key were brought and the show played, also after the power was off; a damaged one was "
      "refused; the face kept {:.2f} of its rate meanwhile; a support file of {:.0f} KB was written onto a "
      "stick",
      scene.finding.figures["install_under_play_rate"], scene.finding.figures["support_file_kb"]);
  return ok;
}

// The control: with the key off the same stick is unauthorised, and nothing is read of it.
Result<void> NothingIsReadWithoutTheKey(Scene& scene) {
  PlayStrategy box(scene.target);
  auto ok = box.Play(StickSetup(""));
  if (ok) ok = Plug(scene, "guest.stick");
  if (ok) ok = WantFoundWrong(WantStickSaid(scene, "guest", seconds(60)), "a stick is read without the key");
  if (ok) ok = WantDead(scene);
  static_cast<void>(scene.target.machine().PullUnauthorised());
  if (ok) box.Off();
  return ok;
}

// Firmware plays no part in it: the update is brought in and waits, and this disk is never started again.
Result<void> TakesAnUpdate(Scene& scene) {
  auto ok = InService(scene, "updated.disk", [&]() -> Result<void> {
    if (auto plugged = Plug(scene, "update.stick"); !plugged) return plugged;
    if (auto listed = WantStickSaid(scene, "> 1. ", kLongestReading); !listed) return listed;
    return InstallUnderPlay(scene, kUpdate);
  });
  scene.finding.said =
      fmt::format("an update was written within {:.0f} s; the face kept {:.2f} of its rate meanwhile",
                  scene.finding.figures[kUpdate.took_s], scene.finding.figures[kUpdate.rate]);
  return ok;
}

// The control: with the key off no update is taken.
Result<void> NoUpdateWithoutTheKey(Scene& scene) {
  PlayStrategy box(scene.target);
  auto ok = box.Play(StickSetup(""));
  if (ok) ok = Plug(scene, "update.stick");
  if (ok)
    ok = WantFoundWrong(WantStickSaid(scene, "> 1. ", seconds(60)), "an update is read without the key");
  static_cast<void>(scene.target.machine().PullUnauthorised());
  if (ok) box.Off();
  return ok;
}

}  // namespace

std::vector<Check> StickChecks() {
  return {
      {.name = "stick",
       .sentence =
           "A show that a stick brings while the service key is on is played, and a damaged one is refused",
       .run = BringsAShow,
       .setup = StickSetup(""),
       .control = NothingIsReadWithoutTheKey,
       .powers = true,
       .stick = "guest"},
      {.name = "update-under-play",
       .sentence = "The face plays on while a stick brings an update",
       .run = TakesAnUpdate,
       .setup = StickSetup(""),
       .control = NoUpdateWithoutTheKey,
       .powers = true,
       .stick = "update"}};
}

}  // namespace kaori::hil
