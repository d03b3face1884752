// A box's backup on a real stick makes a second box of another one, whose data partition is empty.
#include <chrono>
#include <filesystem>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/stick_scene.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

constexpr Duration kLongestCopy =
    std::chrono::minutes(20);  // At the lowest priority, beside a face that wants all.
constexpr const char* kNumber = "read /etc/machine-id";

// What the first box shows: its show and its number.
struct First {
  std::string show, number, stick;
};

// Chooses the line of the list with these words, and waits for what the box says of it.
Result<void> ChooseLine(Scene& scene, std::string_view line, std::string_view answer, Duration longest) {
  if (auto ok = WantStickSaid(scene, line, kLongestReading); !ok) return ok;
  const auto key = KeyOfLine(scene, line);
  if (!key) return tl::unexpected(key.error());
  if (PressFor(scene, *key, answer)) return {};
  return WantStickSaid(scene, answer, longest);
}

// A show of its own, and its backup on a stick that was empty.
Result<First> BackUp(Scene& scene) {
  if (auto ok = BringKey(scene); !ok) return tl::unexpected(ok.error());
  if (auto ok = ChooseLine(scene, "evening  ", "it is on the box and plays now", kLongestCopy); !ok)
    return tl::unexpected(ok.error());
  const auto show = ChosenId(scene);
  if (!show) return tl::unexpected(show.error());
  const auto stick = PlugEmptyStick(scene, "backup");
  if (!stick) return tl::unexpected(stick.error());
  if (auto ok = ChooseLine(scene, "backup of this box", "the backup is on the stick", kLongestCopy); !ok)
    return tl::unexpected(ok.error());
  return First{*show, TextInBox(scene, kNumber), *stick};
}

// Everything is listed before anybody agrees, and done at the next start.
Result<void> Restore(Scene& scene, const First& first) {
  if (auto ok = scene.target.machine().PlugStick(first.stick, true); !ok) return ok;
  if (auto ok = ChooseLine(scene, "restore kaori-", "nothing has changed yet", kLongestCopy); !ok) return ok;
  if (auto ok = WantStickSaid(scene, "new     settings/keys/", std::chrono::seconds(5)); !ok) return ok;
  return ChooseLine(scene, "yes, restore this", "switch the box off and on", kLongestCopy);
}

// The key is turned off in each case, since the next check finds the bridge as it was left.
template <class Work>
auto WithKey(Scene& scene, const Work& work) {
  scene.target.rig().gpio().Close(kStickKey);
  auto done = work();
  scene.target.rig().gpio().Open(kStickKey);
  static_cast<void>(scene.target.machine().PullUnauthorised());
  return done;
}

// From the stick in the second box to its face, the restart between included. Everything is emulated, so a PC is faster.
Result<void> SecondBox(Scene& scene, PlayStrategy& box, const std::string& disk, const First& first) {
  auto ok = box.Play(StickSetup(disk));
  const auto begun = std::chrono::steady_clock::now();
  if (ok) ok = WithKey(scene, [&] { return Restore(scene, first); });
  box.Off();
  if (ok) ok = box.Play(StickSetup(disk));
  if (ok) ok = WantPlayed(scene, first.show);
  if (ok)
    scene.finding.figures["clone_minutes"] =
        std::chrono::duration<double, std::ratio<60>>(std::chrono::steady_clock::now() - begun).count();
  if (ok && TextInBox(scene, kNumber) == first.number) ok = FailInput("two boxes have one number");
  if (ok) ok = scene.ShootFace("backup", "A second box, made by the backup of the first one");
  box.Off();
  return ok;
}

// Two copies of the image's disk are two boxes that were never set up alike; only the stick goes from one to the other.
Result<void> Backup(Scene& scene) {
  const QemuOptions& options = scene.target.machine().options();
  if (!std::filesystem::exists(options.sticks + "/evening.stick"))
    return scene.Skip("there are no sticks to plug in; --sticks names their folder");
  const auto copy = [&](const char* name) {
    return CopyDisk(options.image + "/kaori.disk", options.folder, name, "data");
  };
  const auto one = copy("first.disk"), other = copy("second.disk");
  if (!one || !other) return tl::unexpected((!one ? one : other).error());
  PlayStrategy box(scene.target);
  auto ok = box.Play(StickSetup(one->file));
  const auto first =
      ok ? WithKey(scene, [&] { return BackUp(scene); }) : Result<First>(tl::unexpected(ok.error()));
  box.Off();
  ok = first ? SecondBox(scene, box, other->file, *first) : Result<void>(tl::unexpected(first.error()));
  for (const auto& disk : {one->file, other->file}) std::filesystem::remove(disk);
  scene.finding.said =
      "a backup on a FAT stick made a second box that plays the same show under another number";
  return ok;
}

// The control: without a yes the next start changes nothing.
Result<void> NothingIsRestoredWithoutABackup(Scene& scene) {
  PlayStrategy box(scene.target);
  auto ok = box.Play(StickSetup(""));
  if (ok) ok = WantFoundWrong(WantPlayed(scene, std::string(64, '0')), "a show plays that nobody brought");
  box.Off();
  return ok;
}

}  // namespace

std::vector<Check> BackupChecks() {
  return {{"backup",
           "A backup that a box writes onto a stick makes a second box with the same show and a number of "
           "its own",
           false,
           Backup,
           StickSetup(""),
           {},
           NothingIsRestoredWithoutABackup,
           true}};
}

}  // namespace kaori::hil
