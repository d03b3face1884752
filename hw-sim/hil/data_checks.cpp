// The data partition: one that is ruined is brought back by the service key, and the journal of an evening is
// kept over a power cut.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "drivers/base/whole_file.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/journal_usage.h"
#include "hw-sim/hil/process.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

constexpr Duration kDataAnswer = seconds(60);
// e2fsck and mke2fs read and write some megabytes; the programs start anew after them.
constexpr Duration kLongestMending = seconds(300);
constexpr int kServiceLine = 2;  // Of the bridge, as docs/image.md wires it.
constexpr std::size_t kDataBlock_bytes = 1024;
constexpr const char* kFaults = "read /run/kaori-profile/faults";
constexpr const char* kKeptSettings = "read /var/lib/kaori/settings/box.toml";

// A way in which a partition is ruined, what the box says of it, and what the key makes of it.
struct Ruin {
  const char* name;
  const char* debugfs;        // Changes by debugfs, a line each; null: none.
  std::size_t from_bytes;     // Other bytes from here on,
  std::size_t other_bytes;    // so many of them,
  bool is_noise;              // noise, or zeroes.
  std::string_view at_start;  // What the status says before the key is on.
  std::string_view at_end;    // And after; empty: there is nothing to mend.
  bool keeps_settings;        // Whether what was kept is there again.
};

constexpr std::size_t kAll = ~std::size_t{};  // To the partition's end.
constexpr std::string_view kMendedAtStart = "was damaged and is mended";

// The first four are mended at the start; the last of them is as the kernel leaves one in which it has met an error. So would the
// fifth be, but e2fsck removes a folder of it only when it is told to. Of the sixth e2fsck finds a copy of the superblock, and no more
// than that: its folders are made anew. Nothing mends the last.
constexpr std::array kRuins{
    Ruin{"a torn superblock", nullptr, kDataBlock_bytes, kDataBlock_bytes, true, kMendedAtStart, "", true},
    Ruin{"a superblock of zeroes", nullptr, kDataBlock_bytes, kDataBlock_bytes, false, kMendedAtStart, "",
         true},
    Ruin{"a lost journal", "clri <8>\n", 0, 0, false, kMendedAtStart, "", true},
    Ruin{"errors that were met", "ssv error_count 3\nssv state 2\n", 0, 0, false, kMendedAtStart, "", true},
    Ruin{"errors that cost a folder", "sif lips block[0] 0\nssv error_count 3\nssv state 2\n", 0, 0, false,
         "has errors that want a person's word", "is mended in part", true},
    Ruin{"noise over its beginning", nullptr, 0, std::size_t{48} << 20U, true, "cannot be mounted",
         "is mended in part", false},
    Ruin{"noise", nullptr, 0, kAll, true, "cannot be mounted", "is made anew", false}};

// What is written stays, since the next start is to find it.
Setup SetupOn(const std::string& disk) {
  return {.sound = false, .keeps_disk = true, .width_px = 480, .height_px = 270, .disk = disk};
}

// A copy of the image's disk whose data partition is ruined.
Result<std::string> RuinedDisk(Scene& scene, const Ruin& ruin) {
  const QemuOptions& options = scene.target.machine().options();
  const auto copy = CopyDisk(options.image + "/kaori.disk", options.folder, "ruined.disk", "data");
  if (!copy) return tl::unexpected(copy.error());
  if (ruin.debugfs != nullptr) {
    const std::string changes = options.folder + "/ruin.debugfs";
    auto ok = WriteWholeFile(changes, {AsBytes(ruin.debugfs)});
    if (ok)
      ok = RunToEnd({"debugfs", "-w", "-f", changes, NameInDebugfs(*copy)}, options.folder + "/debugfs.log");
    if (!ok) return tl::unexpected(ok.error());
  }
  const auto span = PartitionSpan(copy->file, "data");
  if (!span) return tl::unexpected(span.error());
  std::string other(std::min<std::size_t>(ruin.other_bytes, span->bytes - ruin.from_bytes), '\0');
  if (ruin.is_noise) std::ranges::generate(other, [&] { return static_cast<char>(scene.chance()); });
  std::fstream file(copy->file, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(static_cast<std::streamoff>(copy->start_bytes + ruin.from_bytes));
  file.write(other.data(), static_cast<std::streamsize>(other.size()));
  if (!file.flush()) return Fail(std::errc::io_error, "write " + copy->file);
  return copy->file;
}

// What the first program and kaori-data found wrong is told to everybody by one file in memory, which the status shows.
// Errors: invalid_argument, the box says something else; with what it says.
Result<void> WantSaid(Scene& scene, const Ruin& ruin, std::string_view words, Duration longest) {
  std::string faults;
  const auto says = [&] {
    faults = scene.target.agent().Ask(kFaults, kDataAnswer).value_or("");
    return faults.find(words) != std::string::npos;
  };
  if (scene.target.Until(says, longest)) return {};
  return FailInput(fmt::format("{}: the box does not say \"{}\", but \"{}\"", ruin.name, words, faults));
}

// The partition is mounted, and has what it should have.
Result<void> WantKept(Scene& scene, const Ruin& ruin) {
  const auto mounts = scene.target.agent().Ask("read /proc/mounts", kDataAnswer);
  if (!mounts) return tl::unexpected(mounts.error());
  if (mounts->find(" /var/lib/kaori ext4 rw") == std::string::npos)
    return FailInput(fmt::format("{}: nothing is mounted that could keep anything", ruin.name));
  const bool settings = scene.target.agent().Ask(kKeptSettings, kDataAnswer).has_value();
  if (settings != ruin.keeps_settings)
    return FailInput(
        fmt::format("{}: the settings that were kept are {}", ruin.name, settings ? "there" : "lost"));
  return {};
}

// The key is turned on until the box says what became of the partition.
Result<void> TurnKey(Scene& scene, const Ruin& ruin) {
  const auto lines = [](const BoardView& board) { return board.lines_live; };
  if (auto seen = scene.target.UntilBoard(lines, kDataAnswer, "see the lines"); !seen)
    return tl::unexpected(seen.error());
  scene.target.rig().gpio().Close(kServiceLine);
  auto said = WantSaid(scene, ruin, ruin.at_end, kLongestMending);
  scene.target.rig().gpio().Open(kServiceLine);
  if (!said) return said;
  const auto plays = [](const BoardView& board) { return board.stage.live && board.lips_live; };
  if (auto seen = scene.target.UntilBoard(plays, kLongestMending, "see stage and lips again"); !seen)
    return tl::unexpected(seen.error());
  return scene.ShootFace("ruined", fmt::format("After {}, mended", ruin.name));
}

// Three ways to fail: the log does not say what was found, what was kept is not there as it should be, or the
// next start finds something again. The disk is a copy, and removed in each case.
Result<void> WantMended(Scene& scene, const Ruin& ruin) {
  const auto disk = RuinedDisk(scene, ruin);
  if (!disk) return tl::unexpected(disk.error());
  PlayStrategy box(scene.target);
  auto ok = box.Play(SetupOn(*disk));
  if (ok) ok = WantSaid(scene, ruin, ruin.at_start, seconds(5));
  if (ok && !ruin.at_end.empty()) ok = TurnKey(scene, ruin);
  if (ok) ok = WantKept(scene, ruin);
  box.Off();
  // The next start finds a whole one.
  if (ok) {
    ok = box.Play(SetupOn(*disk));
    if (ok) ok = WantKept(scene, ruin);
    if (ok && WantSaid(scene, ruin, "the data partition", seconds(2)))
      ok = FailInput(fmt::format("{}: the next start has something to say of the partition", ruin.name));
    box.Off();
  }
  std::filesystem::remove(*disk);
  return ok;
}

// Each on a disk of its own, since what is mended is not ruined any more.
Result<void> Ruined(Scene& scene) {
  for (const Ruin& ruin : kRuins)
    if (auto ok = WantMended(scene, ruin); !ok) return ok;
  scene.finding.said =
      "at the start mended: a superblock of noise or of zeroes, a lost journal, and errors; by the service "
      "key "
      "in part, and said so: errors that cost a folder, and noise over its beginning; made anew: noise";
  return {};
}

// The control: while the key is off nothing is mended.
Result<void> NothingIsMendedWithoutTheKey(Scene& scene) {
  const Ruin& ruin = kRuins.back();
  const auto disk = RuinedDisk(scene, ruin);
  if (!disk) return tl::unexpected(disk.error());
  PlayStrategy box(scene.target);
  auto ok = box.Play(SetupOn(*disk));
  if (ok)
    ok = WantFoundWrong(WantSaid(scene, ruin, ruin.at_end, seconds(30)), "it is made anew without the key");
  box.Off();
  std::filesystem::remove(*disk);
  return ok;
}

constexpr const char* kMachineId = "read /etc/machine-id";
// As the box's journald.conf has it, with time for a slow machine.
constexpr Duration kUntilSynced = seconds(30);

// Whether the journal has an evening before this one, whose number is -1 (journalctl(1)). It is asked first: of an evening that
// it does not have journalctl makes an error, which would be taken for one of the agent.
Result<bool> HasEveningBefore(Scene& scene) {
  const auto listed =
      scene.target.agent().Ask("own /usr/bin/journalctl --list-boots --no-pager", kDataAnswer);
  if (!listed) return tl::unexpected(listed.error());
  std::istringstream lines(*listed);
  std::string number;
  for (std::string line; std::getline(lines, line);)
    if (std::istringstream(line) >> number && number == "-1") return true;
  return false;
}

// What the stage said in the evening before this one. Errors: invalid_argument (nothing is kept).
Result<void> WantEveningBefore(Scene& scene) {
  const auto has = HasEveningBefore(scene);
  if (!has) return tl::unexpected(has.error());
  if (!*has) return FailInput("the journal has no evening before this one");
  const auto said = scene.target.agent().Ask(
      "own /usr/bin/journalctl -b -1 --no-pager -o cat -n 100 -u kaori-stage", kDataAnswer);
  if (!said) return tl::unexpected(said.error());
  if (said->find("is opened on") != std::string::npos) return {};
  return FailInput(fmt::format("the journal keeps nothing of the stage's last evening, but \"{}\"", *said));
}

// Errors: timed_out, the journal stays in memory.
Result<void> AwaitKeptJournal(Scene& scene) {
  const auto kept = [&] {
    return scene.target.agent().Ask("read /run/systemd/journal/flushed", kDataAnswer).has_value();
  };
  if (!scene.target.Until(kept, kDataAnswer))
    return Fail(std::errc::timed_out, "wait until the journal is kept");
  scene.target.Until([] { return false; }, kUntilSynced);
  return {};
}

// The journal may take so much: SystemMaxUse= of the box's journald.conf, 16 MiB.
constexpr double kMostJournal_mb = 16.78;

// What the journal takes, with its bounds: one that takes nothing was not kept. Errors: invalid_argument, it takes too much, or
// journalctl says something else than it is known to say.
Result<double> WantBoundedJournal(const std::string& said) {
  auto kept_mb = JournalIn_mb(said);
  if (!kept_mb || (*kept_mb > 0 && *kept_mb <= kMostJournal_mb)) return kept_mb;
  return FailInput(
      fmt::format("the journal takes {:.1f} MB, and at most {} are wanted", *kept_mb, kMostJournal_mb));
}

// Two evenings with a power cut between them: the second knows what was said in the first, and that it is the
// same box.
Result<void> KeepsTheJournal(Scene& scene) {
  const QemuOptions& options = scene.target.machine().options();
  const auto disk = CopyDisk(options.image + "/kaori.disk", options.folder, "journal.disk", "data");
  if (!disk) return tl::unexpected(disk.error());
  PlayStrategy box(scene.target);
  std::array<std::string, 2> number, usage;
  Result<void> ok;
  for (std::size_t evening = 0; ok && evening < 2; ++evening) {
    ok = box.Play(SetupOn(disk->file));
    if (ok && evening == 1) ok = WantEveningBefore(scene);
    if (ok) ok = AwaitKeptJournal(scene);
    number[evening] = scene.target.agent().Ask(kMachineId, kDataAnswer).value_or("");
    usage[evening] =
        scene.target.agent().Ask("own /usr/bin/journalctl --disk-usage", kDataAnswer).value_or("");
    box.Off();
  }
  std::filesystem::remove(disk->file);
  if (!ok) return ok;
  if (number[0].empty() || number[0] != number[1])
    return FailInput(
        fmt::format("the box has another number after a power cut: {} and {}", number[0], number[1]));
  scene.finding.said = "what the stage said before a power cut stands in the journal after it";
  scene.finding.texts.emplace_back("the room that the journal takes", usage[1]);
  const auto kept_mb = WantBoundedJournal(usage[1]);
  if (kept_mb) scene.finding.figures["journal_kept_mb"] = *kept_mb;
  return kept_mb.map([](double) {});
}

// The control: in its first evening a box has none before it.
Result<void> TheFirstEveningHasNoneBefore(Scene& scene) {
  PlayStrategy box(scene.target);
  Setup first = SetupOn("");
  first.keeps_disk = false;
  auto ok = box.Play(first);
  if (ok) ok = WantFoundWrong(WantEveningBefore(scene), "a new disk has an evening before its first");
  box.Off();
  return ok;
}

}  // namespace

std::vector<Check> DataChecks() {
  return {{"journal",
           "What the box said in an evening is kept over a power cut",
           false,
           KeepsTheJournal,
           SetupOn(""),
           {},
           TheFirstEveningHasNoneBefore,
           true},
          {"ruined-data",
           "A ruined data partition is mended or made anew by the service key",
           false,
           Ruined,
           SetupOn(""),
           {},
           NothingIsMendedWithoutTheKey,
           true}};
}

}  // namespace kaori::hil
