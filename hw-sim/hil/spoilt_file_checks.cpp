// The show in the root, or the stage itself, has rotted on its disk: the show's copy plays, or the other system, which stays.
#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/updated_pc.h"

namespace kaori::hil {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

// Nothing but the disk tells the bench what the box has decided: it has no agent, as an image that ships.

// From a face to the minute's end at which a system stays, on a machine whose processor draws.
constexpr Duration kLongestStaying = minutes(6);
// How long a box plays by which a show that is whole is not given up.
constexpr Duration kPlaysOn = seconds(60);

// From power until the show has been seen for a minute and was copied by a program that rests while the face needs the disk.
constexpr Duration kLongestCopying = minutes(15);
constexpr Duration kCopyLooks = seconds(10);  // Between two looks at what the machine has written.
constexpr std::size_t kMostShow_bytes = std::size_t{256} << 20U;
// Behind the three minutes after which kaori-other.timer asks whether a face was shown.
constexpr Duration kPlaysItsCopy = seconds(200);

// A file of the root, whose disk spoils one bit of it.
struct Spoilt {
  const char* file;    // Below the root.
  const char* what;    // For people.
  const char* figure;  // For out/boot.json.
};

constexpr Spoilt kSpoiltShow{"/usr/share/kaori/kaori.kaori", "show", "spoilt_show_gives_way_s"};
constexpr Spoilt kSpoiltStage{"/usr/bin/kaori-stage", "stage", "spoilt_stage_gives_way_s"};

// What is to be seen here is a chain. Of a show: the kernel refuses the block, the stage ends by it twice, reads the whole show, finds
// no copy (the box was never seen for a minute), and says so by a file; systemd then has kaori-update try the other slot. Of the
// stage: it ends again and again before it can say a word, and three minutes after the start kaori-update is asked whether a face
// was shown. Each link has its unit tests; that they meet is shown by the PC that starts again, and by the slot that starts
// from then on.
//
// The machine of the first start ends by itself: QEMU does not start a PC again.
Result<void> SpoiltGivesWay(Scene& scene, const Spoilt& spoilt) {
  const auto pc = UpdatedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto ok = pc->SpoilFile(scene.target.machine().options().image + "/root" + spoilt.file);
  if (ok) ok = pc->Start(scene);
  const Time began = scene.target.clock().now();
  const auto ended = [&] { return !scene.target.machine().runs(); };
  if (ok && !scene.target.Until(ended, kLongestUpdateStart))
    ok = FailInput(fmt::format("a box whose {} is spoilt does not try its other system", spoilt.what));
  scene.finding.figures[spoilt.figure] = Seconds(scene.target.clock().now() - began);
  scene.target.machine().Off();
  if (ok) ok = pc->Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of the other system");
  const auto stays = [&] { return pc->Default() == 'b'; };
  if (ok && !scene.target.Until(stays, kLongestStaying))
    ok = FailInput("the other system does not stay, though its face was there");
  if (ok) ok = scene.ShootFace(fmt::format("spoilt-{}", spoilt.what), "The other system plays");
  scene.target.machine().Off();
  scene.finding.said =
      fmt::format("with one flipped bit in its {} the box tried its other system after {:.0f} s, which stays",
                  spoilt.what, scene.finding.figures[spoilt.figure]);
  return ok;
}

// A box that has played for a minute keeps its show, byte by byte, on its data partition.
Result<void> AwaitCopy(Scene& scene, const UpdatedPc& pc) {
  const std::string pack = scene.target.machine().options().image + "/root" + kSpoiltShow.file;
  const auto wanted = ReadFile(pack, {.most_bytes = kMostShow_bytes});
  if (!wanted) return tl::unexpected(wanted.error());
  const Time until = scene.target.clock().now() + kLongestCopying;
  while (scene.target.clock().now() < until) {
    scene.target.For(kCopyLooks);
    if (pc.Kept("shows/root.copy", kMostShow_bytes) == *wanted) return {};
  }
  return Fail(std::errc::timed_out, "see the copy of the box's own show on its disk");
}

// As SpoiltGivesWay, of a box that has such a copy: the third stage reads the whole show, and plays the copy. That it is the copy
// is seen by the machine, which does not start again, as it does without one.
Result<void> ItsCopyPlays(Scene& scene) {
  const auto pc = UpdatedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto ok = pc->Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, "before its show is spoilt");
  if (ok) ok = AwaitCopy(scene, *pc);
  scene.target.machine().Off();
  if (ok) ok = pc->SpoilFile(scene.target.machine().options().image + "/root" + kSpoiltShow.file);
  const Time began = scene.target.clock().now();
  if (ok) ok = pc->Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of the copy");
  scene.finding.figures["spoilt_show_copy_plays_s"] = Seconds(scene.target.clock().now() - began);
  const auto ended = [&] { return !scene.target.machine().runs(); };
  if (ok && scene.target.Until(ended, kPlaysItsCopy))
    ok = FailInput("a box with a copy of its spoilt show tries its other system");
  if (ok) ok = AwaitUpdateFace(scene, "of the copy, later");
  scene.target.machine().Off();
  if (ok && pc->Default() != 'a') ok = FailInput("a box that plays its show's copy changes its system");
  return ok;
}

// With a copy and without one.
Result<void> SpoiltShowGivesWay(Scene& scene) {
  if (auto ok = ItsCopyPlays(scene); !ok) return ok;
  auto ok = SpoiltGivesWay(scene, kSpoiltShow);
  scene.finding.said += fmt::format("; where it had a copy of the show, that played after {:.0f} s",
                                    scene.finding.figures["spoilt_show_copy_plays_s"]);
  return ok;
}

Result<void> SpoiltStageGivesWay(Scene& scene) {
  return SpoiltGivesWay(scene, kSpoiltStage);
}

// The control: what is whole plays on, and its system stays.
Result<void> AWholeRootPlaysOn(Scene& scene) {
  const auto pc = UpdatedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto ok = pc->Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of a whole root");
  const auto ended = [&] { return !scene.target.machine().runs(); };
  if (ok && scene.target.Until(ended, kPlaysOn)) ok = FailInput("a box with a whole root gives it up");
  scene.target.machine().Off();
  if (ok && pc->Default() != 'a') ok = FailInput("a box with a whole root changes its system");
  return ok;
}

}  // namespace

// As UpdateChecks, which come before.
std::vector<Check> SpoiltFileChecks() {
  return {{.name = "spoilt-show",
           .sentence =
               "Where a bit of the root's show has flipped, its copy plays, or the other system, which stays",
           .run = SpoiltShowGivesWay,
           .setup = {.plugged = false, .sound = false, .agent = false},
           .control = AWholeRootPlaysOn,
           .powers = true},
          {.name = "spoilt-stage",
           .sentence = "Where a bit of the stage itself has flipped, the other system plays and stays",
           .run = SpoiltStageGivesWay,
           .setup = {.plugged = false, .sound = false, .agent = false},
           .control = AWholeRootPlaysOn,
           .powers = true}};
}

}  // namespace kaori::hil
