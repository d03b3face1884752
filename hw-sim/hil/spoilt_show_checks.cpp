// The show in the root has rotted on its disk: the other system plays, and stays.
#include <fmt/format.h>

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

// The file from which the image's root was made.
std::string ShowOf(const Scene& scene) {
  return scene.target.machine().options().image + "/root/usr/share/kaori/kaori.kaori";
}

// What is to be seen here is a chain: the kernel refuses the block, the stage ends by it twice, reads the whole show, finds no
// copy (the box was never seen for a minute), and says so by a file; systemd then has kaori-update try the other slot. Each
// link has its unit tests; that they meet is shown by the PC that starts again, and by the slot that starts from then on.
//
// The machine of the first start ends by itself: QEMU does not start a PC again.
Result<void> SpoiltShowGivesWay(Scene& scene) {
  const auto pc = UpdatedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto ok = pc->SpoilShow(ShowOf(scene));
  if (ok) ok = pc->Start(scene);
  const Time began = scene.target.clock().now();
  const auto ended = [&] { return !scene.target.machine().runs(); };
  if (ok && !scene.target.Until(ended, kLongestUpdateStart))
    ok = FailInput("a box whose show is spoilt does not try its other system");
  scene.finding.figures["spoilt_show_gives_way_s"] = Seconds(scene.target.clock().now() - began);
  scene.target.machine().Off();
  if (ok) ok = pc->Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of the other system");
  const auto stays = [&] { return pc->Default() == 'b'; };
  if (ok && !scene.target.Until(stays, kLongestStaying))
    ok = FailInput("the other system does not stay, though its face was there");
  if (ok) ok = scene.ShootFace("spoilt-show", "The other system plays");
  scene.target.machine().Off();
  scene.finding.said = fmt::format(
      "with one flipped bit in its show the box tried its other system after {:.0f} s, which stays",
      scene.finding.figures["spoilt_show_gives_way_s"]);
  return ok;
}

// The control: a show that is whole plays on, and its system stays.
Result<void> AWholeShowPlaysOn(Scene& scene) {
  const auto pc = UpdatedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto ok = pc->Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of a whole show");
  const auto ended = [&] { return !scene.target.machine().runs(); };
  if (ok && scene.target.Until(ended, kPlaysOn)) ok = FailInput("a box with a whole show gives it up");
  scene.target.machine().Off();
  if (ok && pc->Default() != 'a') ok = FailInput("a box with a whole show changes its system");
  return ok;
}

}  // namespace

std::vector<Check> SpoiltShowChecks() {
  return {
      {.name = "spoilt-show",
       .sentence = "Where a bit of the root's show has flipped, the other system plays and stays",
       .run = SpoiltShowGivesWay,
       .setup = {.plugged = false, .sound = false, .agent = false},  // As UpdateChecks, which come before.
       .control = AWholeShowPlaysOn,
       .powers = true}};
}

}  // namespace kaori::hil
