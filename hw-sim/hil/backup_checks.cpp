// A box's backup on a real stick makes a second box of another one, whose data partition is empty.
#include <algorithm>
#include <chrono>
#include <filesystem>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/stick_scene.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

constexpr const char* kNumber = "read /etc/machine-id";
// What a box plays (appliance/core/store/play_log.h), and where its data partition is.
constexpr const char* kPlays = "read /run/kaori/plays";
constexpr std::string_view kData = "/var/lib/kaori/", kBroughtKeys = "settings/keys/";
// Of the stick that the check leaves in its folder, for its control.
constexpr const char* kBackupStick = "backup";

// What the first box shows: its show and its number.
struct First {
  std::string show, number, stick;
};

// A show of its own, and its backup on a stick that was empty.
Result<First> BackUp(Scene& scene) {
  if (auto ok = BringKey(scene, "evening"); !ok) return tl::unexpected(ok.error());
  if (auto ok = ChooseLine(scene, "evening  ", "it is on the box and plays now", kLongestInstalling); !ok)
    return tl::unexpected(ok.error());
  const auto show = ChosenId(scene);
  if (!show) return tl::unexpected(show.error());
  const auto stick = PlugEmptyStick(scene, kBackupStick);
  if (!stick) return tl::unexpected(stick.error());
  if (auto ok = ChooseLine(scene, "backup of this box", "the backup is on the stick", kLongestInstalling);
      !ok)
    return tl::unexpected(ok.error());
  return First{*show, TextInBox(scene, kNumber), *stick};
}

// Whether the box has a file. Errors: those of the agent, but for its own message, which says that there is none.
Result<bool> IsOnBox(Scene& scene, const std::string& file) {
  const auto read = scene.target.agent().Ask("read " + file, kLongestReading);
  if (read) return true;
  if (read.error().cause == std::errc::invalid_argument) return false;
  return tl::unexpected(read.error());
}

// Wants the file on the box, or not.
Result<void> WantOnBox(Scene& scene, const std::string& file, bool there) {
  const auto found = IsOnBox(scene, file);
  if (!found) return tl::unexpected(found.error());
  if (*found == there) return {};
  return FailInput(fmt::format("{} is {} the box", file, there ? "not on" : "on"));
}

// Plugs the backup in and goes up to the question, at which everything is listed and nothing has changed. Gives the file of the
// first box's key, as the list names it.
Result<std::string> ListRestore(Scene& scene, const std::string& stick) {
  constexpr std::string_view kNewKey = "new     settings/keys/";
  if (auto ok = scene.target.machine().PlugStick(stick, true); !ok) return tl::unexpected(ok.error());
  if (auto ok = ChooseLine(scene, "restore kaori-", "nothing has changed yet", kLongestInstalling); !ok)
    return tl::unexpected(ok.error());
  if (auto ok = WantStickSaid(scene, kNewKey, std::chrono::seconds(5)); !ok)
    return tl::unexpected(ok.error());
  const std::string said = TextInBox(scene, kSaid);
  const std::size_t at = std::min(said.find(kBroughtKeys), said.size());
  std::string key = std::string(kData) + said.substr(at, said.find_first_of(" \n", at) - at);
  if (!key.ends_with(".pub")) return FailInput("the list names no key: " + said);
  if (auto ok = WantOnBox(scene, key, false); !ok) return tl::unexpected(ok.error());
  return key;
}

// Everything is listed before anybody agrees, and done at the next start. Gives the file of the first box's key.
Result<std::string> Restore(Scene& scene, const First& first) {
  auto key = ListRestore(scene, first.stick);
  if (!key) return key;
  if (auto ok = ChooseLine(scene, "yes, restore this", "switch the box off and on", kLongestInstalling); !ok)
    return tl::unexpected(ok.error());
  return key;
}

// Both must tell theirs: nothing said twice would be one number, and nothing said once another.
Result<void> WantOtherNumber(Scene& scene, const First& first) {
  const std::string number = TextInBox(scene, kNumber);
  if (number.empty() || first.number.empty()) return FailInput("a box does not tell its number");
  return number == first.number ? FailInput("two boxes have one number") : Result<void>{};
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

// By the clock of the machine, which is this computer's: its processor is emulated, so that a PC is faster.
constexpr double kMostClone_minutes = 2;

// A first start has work of its own, which goes on behind its face: shaders that are compiled, a copy of the box's own show. Nobody
// clones a box meanwhile, and an emulated one would do both at half the pace.
Result<void> AwaitEndOfFirstStart(Scene& scene) {
  constexpr const char* kLastOfIt = "own /usr/bin/journalctl -b --no-pager -o cat -u kaori-keep";
  const auto ended = [&] { return TextInBox(scene, kLastOfIt).find("Finished") != std::string::npos; };
  if (scene.target.Until(ended, kLongestInstalling)) return {};
  return FailInput("the second box does not end its first start: no copy of its own show is kept");
}

// Counted is from the stick in the second box, which plays, to its face with the first one's show: reading and checking the backup, the
// answer, and the restart. Not counted are the backup itself, which the first box has written before, and the first start of the second one.
Result<void> SecondBox(Scene& scene, PlayStrategy& box, const std::string& disk, const First& first) {
  auto ok = box.Play(StickSetup(disk));
  if (ok) ok = AwaitEndOfFirstStart(scene);
  const Time begun = scene.target.clock().now();
  const auto took_s = [&] { return Seconds(scene.target.clock().now() - begun); };
  auto& figures = scene.finding.figures;
  const auto key = ok ? WithKey(scene, [&] { return Restore(scene, first); })
                      : Result<std::string>(tl::unexpected(ok.error()));
  if (!key) ok = tl::unexpected(key.error());
  figures["clone_restored_s"] = took_s();
  if (ok) box.Off();
  if (ok) ok = box.Play(StickSetup(disk));
  figures["clone_started_s"] = took_s();
  if (ok) ok = WantPlayed(scene, first.show);
  const double took_minutes = took_s() / 60;
  if (ok) figures["clone_minutes"] = took_minutes;
  if (ok && took_minutes > kMostClone_minutes)
    ok = FailInput(fmt::format("a second box took {:.1f} minutes, and at most {} are wanted", took_minutes,
                               kMostClone_minutes));
  if (ok) ok = WantOnBox(scene, *key, true);
  if (ok) ok = WantOtherNumber(scene, first);
  if (ok) ok = scene.ShootFace("backup", "A second box, made by the backup of the first one");
  if (ok) box.Off();
  return ok;
}

// Two copies of the image's disk are two boxes that were never set up alike; only the stick goes from one to the other.
Result<void> Backup(Scene& scene) {
  const QemuOptions& options = scene.target.machine().options();
  const auto copy = [&](const char* name) {
    return CopyDisk(options.image + "/kaori.disk", options.folder, name, "data");
  };
  const auto one = copy("first.disk"), other = copy("second.disk");
  if (!one || !other) return tl::unexpected((!one ? one : other).error());
  PlayStrategy box(scene.target);
  auto ok = box.Play(StickSetup(one->file));
  const auto first =
      ok ? WithKey(scene, [&] { return BackUp(scene); }) : Result<First>(tl::unexpected(ok.error()));
  if (first) box.Off();
  ok = first ? SecondBox(scene, box, other->file, *first) : Result<void>(tl::unexpected(first.error()));
  for (const auto& disk : {one->file, other->file}) std::filesystem::remove(disk);
  scene.finding.said = fmt::format(
      "a backup on a FAT stick made a second box that plays the same show under another number, {:.1f} "
      "minutes after the stick was put "
      "in, its restart counted; the writing of the backup and the first start of the second box are not "
      "counted",
      scene.finding.figures["clone_minutes"]);
  return ok;
}

// The id of the show that the stage plays. Errors: invalid_argument, it notes none.
Result<std::string> PlayingId(Scene& scene) {
  constexpr std::string_view kWord = "playing ";
  const std::string plays = TextInBox(scene, kPlays);
  const std::size_t at = plays.find(kWord);
  if (at == std::string::npos)
    return FailInput("the stage does not say what it plays, but \"" + plays + "\"");
  return plays.substr(at + kWord.size(), plays.find('\n', at) - at - kWord.size());
}

// One start up to the question, which nobody answers, and another one.
Result<void> WantUnchanged(Scene& scene, PlayStrategy& box, const std::string& disk) {
  const std::string stick =
      std::filesystem::path(scene.folder).parent_path() / (std::string(kBackupStick) + ".stick");
  if (auto ok = box.Play(StickSetup(disk)); !ok) return ok;
  const auto show = PlayingId(scene);
  if (!show) return tl::unexpected(show.error());
  const auto key = WithKey(scene, [&] { return ListRestore(scene, stick); });
  if (!key) return tl::unexpected(key.error());
  box.Off();
  if (auto ok = box.Play(StickSetup(disk)); !ok) return ok;
  if (auto ok = WantPlayed(scene, *show); !ok) return ok;
  return WantOnBox(scene, *key, false);
}

// The control: without a yes the next start changes nothing, on a box that has read all of the check's own backup.
Result<void> NothingIsRestoredWithoutAYes(Scene& scene) {
  const QemuOptions& options = scene.target.machine().options();
  const auto disk = CopyDisk(options.image + "/kaori.disk", options.folder, "second.disk", "data");
  if (!disk) return tl::unexpected(disk.error());
  PlayStrategy box(scene.target);
  auto ok = WantUnchanged(scene, box, disk->file);
  if (ok) box.Off();
  std::filesystem::remove(disk->file);
  return ok;
}

}  // namespace

std::vector<Check> BackupChecks() {
  return {{.name = "backup",
           .sentence = "A backup that a box writes onto a stick makes a second box with the same show and a "
                       "number of its own",
           .run = Backup,
           .setup = StickSetup(""),
           .control = NothingIsRestoredWithoutAYes,
           .powers = true,
           .stick = "evening"}};
}

}  // namespace kaori::hil
