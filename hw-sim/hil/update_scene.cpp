#include "hw-sim/hil/update_scene.h"

#include <fmt/format.h>

#include "hw-sim/hil/noise_slot.h"

namespace kaori::hil {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

// The whole file is read, unpacked, written and read back by a program of the idle class, beside a face that takes all that
// the processors give.
constexpr Duration kLongestUpdating = minutes(45);
constexpr Duration kStickListed = seconds(90);  // Of a stick that is plugged in, until it stands in the list.
constexpr Duration kDiskLooks = seconds(10);    // Between two looks at what the machine has written.
constexpr int kUpdateKey = 2;                   // A line of the bridge, as docs/image.md wires it.
constexpr std::uint8_t kFirst = 0x1E, kSecond = 0x1F, kPageUp = 0x4B;  // Keys, HID page 7.

// The presses are those of a stage hand who has only the sheet beside the box: the key, the stick, a number. Where the screen
// shows the list too late for that, the check fails with the picture of what it showed instead.
//
// With the key on the stick is plugged in; the first of the list is taken, which is the update.
Result<void> BringUpdate(Scene& scene, const UpdatedPc& pc) {
  if (auto ok = scene.target.PlugAll(); !ok) return ok;
  scene.target.For(seconds(20));
  scene.target.rig().gpio().Close(kUpdateKey);
  scene.target.For(seconds(10));
  const std::string stick = scene.target.machine().options().sticks + "/update.stick";
  if (auto ok = scene.target.machine().PlugStick(stick, false); !ok) return ok;
  scene.target.For(kStickListed);
  if (auto ok = scene.Shoot("update-list", "The update in the list of the stick"); !ok) return ok;
  scene.TapKey(kFirst);
  const Time began = scene.target.clock().now();
  const auto waits = [](const std::string& kept) { return kept.ends_with(" B 0\n"); };
  auto ok = AwaitKept(scene, pc, "update/pending", waits, kLongestUpdating);
  scene.finding.figures["update_install_s"] = Seconds(scene.target.clock().now() - began);
  static_cast<void>(scene.Shoot("update-waits", "The update waits for a restart"));
  return ok;
}

// Restarting takes a moment in which the programs are stopped: a second press comes only when the first one went nowhere.
//
// The second of the list is the restart; QEMU ends where a PC starts again. The list was shut while the update came in, which
// takes longer than it stands; a press that shuts one that is open costs a try.
Result<void> RestartIntoB(Scene& scene) {
  constexpr int kMostPresses = 3;
  const auto ended = [&] { return !scene.target.machine().runs(); };
  for (int n = 0; n < kMostPresses; ++n) {
    scene.TapKey(kPageUp);
    scene.target.For(seconds(5));
    scene.TapKey(kSecond);
    if (scene.target.Until(ended, seconds(120))) return {};
  }
  static_cast<void>(scene.Shoot("update-no-restart", "What the box says in place of restarting"));
  return FailInput("the box does not restart to try the update");
}

}  // namespace

// The image's disk has the same system in both slots, and the stick has it once more: slot B is made one that cannot start, so that a
// face of it is the face of what was written. Cuts before that leave slot A, which is as it was.
Result<UpdatedPc> PcToUpdate(Scene& scene) {
  auto pc = UpdatedPc::Make(scene);
  if (!pc) return pc;
  if (auto ok = MakeSlotBNoise(pc->Disk(), scene.chance); !ok) return tl::unexpected(ok.error());
  return pc;
}

// Looked at on the host: the machine's own clock and programs play no part.
Result<void> AwaitKept(Scene& scene, const UpdatedPc& pc, const std::string& name,
                       const std::function<bool(const std::string&)>& right, Duration longest) {
  const Time until = scene.target.clock().now() + longest;
  std::string kept;
  while (scene.target.clock().now() < until) {
    scene.target.For(kDiskLooks);
    kept = pc.Kept(name);
    if (right(kept)) return {};
  }
  return Fail(std::errc::timed_out, fmt::format("see {} on the disk, which has \"{}\"", name, kept));
}

// The try is counted before the machine is off: by that the next start knows that it is one.
Result<void> UpdateAndRestart(Scene& scene, const UpdatedPc& pc) {
  auto ok = pc.StartNoted(scene);
  if (ok) ok = AwaitUpdateFace(scene, "before the update");
  if (ok) ok = BringUpdate(scene, pc);
  if (ok && pc.Default() != 'a') ok = FailInput("slot B is confirmed before it was tried");
  if (ok) ok = RestartIntoB(scene);
  scene.target.rig().gpio().Open(kUpdateKey);
  scene.target.machine().Off();
  if (ok && !pc.Kept("update/pending").ends_with(" B 1\n"))
    ok = FailInput("the try was not counted: \"" + pc.Kept("update/pending") + "\"");
  if (ok) pc.KeepRestarted(scene);
  return ok;
}

// What was kept may be of a check before: bringing the update in takes minutes.
Result<UpdatedPc> RestartedPc(Scene& scene) {
  if (auto kept = UpdatedPc::Restarted(scene)) return std::move(*kept);
  auto pc = PcToUpdate(scene);
  if (!pc) return pc;
  if (auto ok = UpdateAndRestart(scene, *pc); !ok) return tl::unexpected(ok.error());
  return pc;
}

}  // namespace kaori::hil
