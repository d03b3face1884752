// Whatever ends, and however full the disk is: the screen is never dark, and the box plays on.
#include <algorithm>
#include <array>
#include <set>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/held_picture.h"
#include "hw-sim/hil/stick_scene.h"

namespace kaori::hil {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

// A small screen, so that the stage is back sooner.
const Setup kStormSetup{.plugged = false, .sound = false, .width_px = 480, .height_px = 270};
// The stage may be starting, which takes all that an emulated machine has.
constexpr Duration kStormAnswer = seconds(120);
// Of the stage, one after the other, each as soon as the machine has a new one: there is no pause that could be shorter.
constexpr std::size_t kKills = 30;
// The goal is ten seconds. One and the same emulated machine took 11 of them in one run and 31 in another; a bench with busy neighbours
// gets three times as long.
constexpr Duration kLongestBurst = seconds(90);
// For each other part: a stage of an emulated machine takes up to a minute.
constexpr Duration kLongestStorm = seconds(300);
constexpr std::array kAllPrograms{"kaori-stage", "kaori-fdkeeper", "kaori-input", "kaori-lips"};
// In the folder of the stage's own files: the last face and the show log are written beside it.
constexpr const char* kFiller = "/var/lib/kaori/own/filler";

// Looks at the screen without a pause until a stage that was made after `since_ns` draws.
Result<void> AwaitStage(Scene& scene, HeldPicture& held, std::int64_t since_ns) {
  const Time until = scene.target.clock().now() + seconds(180);
  while (scene.target.clock().now() < until) {
    if (auto ok = held.Look(scene); !ok) return ok;
    const auto board = scene.target.Board();
    if (board && board->stage.live && board->stage.read_ns > since_ns) return {};
    scene.target.For(milliseconds(20));
  }
  return Fail(std::errc::timed_out, "see the stage again after it was killed");
}

// By the guest's clock, in nanoseconds, as the board has its times.
Result<std::int64_t> Now(Scene& scene) {
  const auto board = scene.target.Board();
  if (!board) return tl::unexpected(board.error());
  return board->now_ns;
}

// Each new stage is killed as soon as its process is there: few of them live long enough to draw.
Result<void> KillAgainAndAgain(Scene& scene, HeldPicture& held) {
  const Time began = scene.target.clock().now(), until = began + kLongestBurst;
  for (std::set<std::string> killed; killed.size() < kKills;) {
    if (scene.target.clock().now() > until)
      return FailInput(fmt::format("the stage came back {} times only in {:.0f} s", killed.size(),
                                   Seconds(kLongestBurst)));
    if (const std::string now = TextInBox(scene, "processes kaori-stage");
        !now.empty() && !killed.contains(now)) {
      if (auto ok = scene.Tell("signal kaori-stage 9"); !ok) return ok;
      killed.insert(now);
    }
    if (auto ok = held.Look(scene); !ok) return ok;
  }
  const double took_s = Seconds(scene.target.clock().now() - began);
  scene.finding.figures["storm_kills_s"] = took_s;
  scene.finding.figures["storm_kills_per_10_s"] = kKills * 10 / took_s;
  const auto now = Now(scene);
  return now ? AwaitStage(scene, held, *now) : tl::unexpected(now.error());
}

// By the service manager at one stroke: its unit's store keeps the card's file while both who hold it are away.
Result<void> KillEverything(Scene& scene, HeldPicture& held) {
  const auto all_run = [&] {
    return std::ranges::all_of(kAllPrograms, [&](const char* program) {
      return !TextInBox(scene, fmt::format("processes {}", program)).empty();
    });
  };
  if (auto ok = scene.target.Await(all_run, kLongestStorm, "see all programs run"); !ok) return ok;
  if (auto ok =
          scene.Tell(fmt::format("own /usr/bin/systemctl kill -s KILL {}", fmt::join(kAllPrograms, " ")));
      !ok)
    return ok;
  const auto now = Now(scene);
  return now ? AwaitStage(scene, held, *now) : tl::unexpected(now.error());
}

// Nothing can be kept then, and everything that keeps something is started anew.
Result<void> FillTheDisk(Scene& scene, HeldPicture& held) {
  const auto filled = scene.target.agent().Ask(std::string("fill ") + kFiller, kStormAnswer);
  if (!filled) return tl::unexpected(filled.error());
  scene.finding.figures["storm_filled_mb"] = std::atof(filled->c_str()) / 1e6;
  auto ok = KillEverything(scene, held);
  const auto freed = scene.target.agent().Ask(std::string("remove ") + kFiller, kStormAnswer);
  if (ok && !freed) ok = tl::unexpected(freed.error());
  return ok;
}

// One part after the other, and one count of pictures over all of them.
Result<void> Storm(Scene& scene) {
  auto held = HoldFace(scene, "storm", "Before anything ends");
  if (!held) return tl::unexpected(held.error());
  for (const auto part : {KillAgainAndAgain, KillEverything, FillTheDisk})
    if (auto ok = part(scene, *held); !ok) return ok;
  if (auto ok = scene.ShootFace("storm", "After all of it"); !ok) return ok;
  scene.finding.figures["storm_pictures"] = held->pictures;
  scene.finding.figures["storm_pictures_wrong"] = held->wrong;
  scene.finding.said = fmt::format(
      "the stage was killed {} times in {:.0f} s ({:.0f} in 10 s), then all programs at once, then all of "
      "them with a full data partition: {} pictures, {} wrong; largest difference {:.3f} of {}",
      kKills, scene.finding.figures["storm_kills_s"], scene.finding.figures["storm_kills_per_10_s"],
      held->pictures, held->wrong, held->largest, HeldPicture::kMovedByItself);
  return held->wrong == 0 ? Result<void>{} : FailInput(scene.finding.said);
}

// The control: without a stage and without who keeps its card, the picture goes, and that is seen. The box is left as it was found.
Result<void> WithoutItsKeepersThePictureGoes(Scene& scene) {
  constexpr const char* kBoth = "kaori-stage.service kaori-fdkeeper.service";
  auto held = HoldFace(scene, "storm-control", "The face");
  if (!held) return tl::unexpected(held.error());
  auto ok = scene.Tell(fmt::format("own /usr/bin/systemctl stop {}", kBoth));
  Result<void> looked;
  const auto is_gone = [&] {
    looked = held->Look(scene);
    return !looked || held->wrong > 0;
  };
  if (ok) scene.target.Until(is_gone, seconds(30));
  // It says that it failed where the stage takes longer than its job may.
  static_cast<void>(scene.Tell(fmt::format("own /usr/bin/systemctl start {}", kBoth)));
  if (ok) ok = looked;
  if (ok) ok = scene.AwaitMovingFace(0, kLongestStorm);
  if (!ok) return ok;
  return held->wrong > 0 ? Result<void>{} : FailInput("the picture stays without anybody who holds it");
}

}  // namespace

std::vector<Check> StormChecks() {
  return {{.name = "storm",
           .sentence = "Whatever ends, and with a full disk, the screen is never dark",
           .run = Storm,
           .setup = kStormSetup,
           .control = WithoutItsKeepersThePictureGoes,
           .ends_programs = true}};
}

}  // namespace kaori::hil
