// The power of a PC with UEFI is switched off again and again, and in the middle of what its firmware keeps: the slot
// that starts stays the same, and a face comes.
#include <algorithm>
#include <filesystem>
#include <random>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/power_cuts.h"
#include "hw-sim/hil/updated_pc.h"
#include "hw-sim/hil/write_log.h"

namespace kaori::hil {
namespace {

constexpr int kCycles = 20, kVariableCuts = 10;  // In each round.
// Of so many cuts one has no face behind it: the next one falls into the start that mends what it left. A number of cycles is a multiple of it.
constexpr int kIntoMending = 4;
// From the firmware's first moment to some frames of the show: so long on a quiet bench, and so many times the first whole start on
// a busy one.
constexpr double kLongestCycle_s = 15, kLongestCycle_starts = 1.2;

// What a start wrote to its disk.
struct WrittenByStart {
  // Elsewhere than on the data partition: by the firmware, the loader, the kernel, anybody.
  std::uint64_t sectors_beside_data = 0;
  // A log without it is that of a start that was cut off before, or of a disk that nobody noted the writes of.
  bool data = false;
};

// Of a PC that is off, by the log that QEMU kept of its disk.
Result<WrittenByStart> WrittenBy(const UpdatedPc& pc) {
  const auto data = PartitionSpan(pc.Disk(), "data");
  if (!data) return tl::unexpected(data.error());
  return WriteLog::Read(pc.DiskLog()).map([&](const WriteLog& log) {
    return WrittenByStart{log.SectorsOutside({*data}), log.WritesInto(*data)};
  });
}

// Of a start that came to its face, which mounts the data partition on its way. Errors: invalid_argument, the log shows nothing of
// that, and so nothing of what lies beside it; or something was written there.
Result<void> WantNothingBesideData(const UpdatedPc& pc) {
  const auto written = WrittenBy(pc);
  if (!written) return tl::unexpected(written.error());
  if (!written->data) return FailInput("the log of a whole start's writes has none to the data partition");
  if (written->sectors_beside_data == 0) return {};
  return FailInput(fmt::format("a start writes {} sectors beside the data", written->sectors_beside_data));
}

// The first start of a PC, in which the firmware lays out what it keeps: no other writes so much of it.
Result<void> StartWhole(Scene& scene, const UpdatedPc& pc, const char* check) {
  const Time began = scene.target.clock().now();
  auto ok = pc.StartNoted(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of a PC's first start");
  if (ok) ok = scene.ShootFace(check, "The face of a PC's first start");
  scene.finding.figures["whole_start_s"] = Seconds(scene.target.clock().now() - began);
  scene.target.machine().Off();
  if (!ok) return ok;
  const auto written = WrittenBy(pc);
  if (!written) return tl::unexpected(written.error());
  scene.finding.figures["start_sectors_written"] = static_cast<double>(written->sectors_beside_data);
  return WantNothingBesideData(pc);
}

// Cuts after so many writes of the first start's firmware, each of them a few bytes of its flash.
Result<void> CutVariables(Scene& scene, const UpdatedPc& pc) {
  const std::string noted = pc.VariablesLog() + ".first";
  std::filesystem::rename(pc.VariablesLog(), noted);
  const auto log = WriteLog::Read(noted);
  if (!log) return tl::unexpected(log.error());
  const std::size_t writes = log->entries().size();
  if (writes == 0) return FailInput("the firmware kept nothing in its first start");
  scene.finding.figures["variable_writes"] = static_cast<double>(writes);
  auto& counts = scene.finding.counts;
  const int cuts = kVariableCuts;
  for (int n = 0; n < cuts; ++n) {
    const std::size_t until = CutPoint(scene, 0, writes, n, cuts);
    auto ok = pc.ForgetVariables();
    if (ok) ok = log->Replay(0, until, pc.Variables());
    if (!ok) return ok;
    counts["variable_cuts"] += 1;
    if (WantFaceOf(scene, pc, "after a cut in the firmware's variables", kLongestUpdateStart)) continue;
    counts["variable_cuts_dead"] += 1;
    return FailInput(fmt::format("no face after a cut behind write {} of {} of the firmware", until, writes));
  }
  return {};
}

// Off again after that long: some are cut off before anything is written.
Result<void> CutStart(Scene& scene, const UpdatedPc& pc, Duration after) {
  if (auto ok = pc.StartNoted(scene); !ok) return ok;
  scene.target.For(after);
  scene.target.machine().Off();
  const auto written = WrittenBy(pc);
  if (!written) return tl::unexpected(written.error());
  auto& counts = scene.finding.counts;
  counts["power_cycles"] += 1;
  counts["power_cycles_with_writes"] += written->data ? 1 : 0;
  if (written->sectors_beside_data == 0 && pc.Default() == 'a') return {};
  counts["slot_flips"] += 1;
  return FailInput(fmt::format("cycle {:.0f}: {} sectors beside the data were written, and slot {} starts",
                               counts["power_cycles"], written->sectors_beside_data, pc.Default()));
}

// The whole start that mends what a cut left. Its log must show that writes are noted.
Result<void> StartToFace(Scene& scene, const UpdatedPc& pc) {
  auto ok = pc.StartNoted(scene);
  if (ok) ok = AwaitUpdateFace(scene, "after the power went");
  scene.target.machine().Off();
  if (ok) ok = WantNothingBesideData(pc);
  if (ok && pc.Default() != 'a') ok = FailInput("a whole start after a cut changes the slot");
  scene.finding.counts["power_cycles_with_face"] += ok ? 1 : 0;
  return ok;
}

// Disk and variables are kept from each cycle to the next.
Result<void> CyclePower(Scene& scene, const UpdatedPc& pc) {
  std::uniform_real_distribution<double> long_s(
      0, std::max(kLongestCycle_s, kLongestCycle_starts * scene.finding.figures["whole_start_s"]));
  for (int n = 0; n < kCycles; ++n) {
    const std::chrono::duration<double> after(long_s(scene.chance));
    auto ok = CutStart(scene, pc, std::chrono::duration_cast<Duration>(after));
    if (ok && n % kIntoMending != 0) ok = StartToFace(scene, pc);
    if (!ok) return ok;
  }
  return scene.finding.counts["power_cycles_with_writes"] > 0 ? Result<void>{}
                                                              : FailInput("no cycle came to write anything");
}

Result<void> VariableCuts(Scene& scene) {
  const auto pc = UpdatedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  scene.finding.counts = {{"variable_cuts", 0}, {"variable_cuts_dead", 0}};
  auto ok = StartWhole(scene, *pc, "variable-cuts");
  if (ok) ok = CutVariables(scene, *pc);
  scene.finding.said =
      fmt::format("{:.0f} cuts in {:.0f} writes of the firmware left a face each",
                  scene.finding.counts["variable_cuts"], scene.finding.figures["variable_writes"]);
  return ok;
}

Result<void> PowerCycles(Scene& scene) {
  const auto pc = UpdatedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto& counts = scene.finding.counts;
  counts = {
      {"power_cycles", 0}, {"power_cycles_with_writes", 0}, {"power_cycles_with_face", 0}, {"slot_flips", 0}};
  auto ok = StartWhole(scene, *pc, "power-cycles");
  if (ok) ok = CyclePower(scene, *pc);
  scene.finding.said = fmt::format(
      "a start wrote nothing beside the data; after {:.0f} switchings, of which {:.0f} came to write, the "
      "same slot starts, and {:.0f} times it was awaited to its face",
      counts["power_cycles"], counts["power_cycles_with_writes"], counts["power_cycles_with_face"]);
  return ok;
}

}  // namespace

std::vector<Check> PowerCycleChecks() {
  Check variable_cuts = {
      .name = "variable-cuts",
      .sentence = "A PC whose power goes while its firmware keeps something comes to its face again",
      .run = VariableCuts,
      .setup = {.plugged = false, .sound = false, .agent = false},  // As UpdateChecks, which come before.
      .control = ASpoiltSlotIsSeen,
      .powers = true,
      .most_rounds = kManyRounds};
  Check power_cycles = variable_cuts;
  power_cycles.name = "power-cycles";
  power_cycles.sentence = "A PC that is switched off at any moment starts the same slot again";
  power_cycles.run = PowerCycles;
  return {variable_cuts, power_cycles};
}

}  // namespace kaori::hil
