// An update of the box by a stick, in a PC with UEFI: it is brought in, tried and stays; a bad one gives way.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/data_cuts.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/power_cuts.h"
#include "hw-sim/hil/slot_b.h"
#include "hw-sim/hil/update_history.h"
#include "hw-sim/hil/update_scene.h"
#include "hw-sim/hil/updated_pc.h"

namespace kaori::hil {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

// The trial itself takes one to three minutes of the machine, whose clock is the host's.
constexpr Duration kLongestTrial = minutes(6);
// In each round.
constexpr int kUpdateCuts = 10, kDataCuts = 2000;
// Of a disk that lies, until one is found wrong.
constexpr int kLiesAtOnce = 20, kMostLies = 200;

// A spoilt slot may take so long to show that it has no face, as in power_cycle_checks.cpp.
constexpr Duration kNoFaceOfB = seconds(60);

// Where partitions of these names lie. Errors: as PartitionSpan.
Result<std::vector<DiskSpan>> Spans(const std::string& disk, std::initializer_list<const char*> names) {
  std::vector<DiskSpan> spans;
  for (const char* name : names) {
    const auto span = PartitionSpan(disk, name);
    if (!span) return tl::unexpected(span.error());
    spans.push_back(*span);
  }
  return spans;
}

// Beside these places the disk has what must start after any cut. They are taken of the disk as all began: an update that moves a file
// in the tables writes into these.
Result<void> WantNothingAstray(Scene& scene, const UpdateHistory& history) {
  const auto allowed = PlacesOfAnUpdate(history.Disk());
  if (!allowed) return tl::unexpected(allowed.error());
  const std::uint64_t astray = history.SectorsOutside(*allowed);
  scene.finding.figures["update_sectors_astray"] = static_cast<double>(astray);
  return astray == 0 ? Result<void>{}
                     : FailInput(fmt::format("an update writes {} sectors where it must not", astray));
}

// The one write that decides comes when all of the new slot is safe, and nothing of that slot is written afterwards.
Result<void> WantOneDecision(const UpdateHistory& history, const UpdatedPc& pc, const DiskSpan& deciding) {
  const auto slot = Spans(pc.Disk(), {"root-b", "verity-b", "boot"});
  if (!slot) return tl::unexpected(slot.error());
  const std::string fault = DecisionFault(history.Writes(), *slot, deciding);
  return fault.empty() ? Result<void>{} : FailInput("of an update: " + fault);
}

// Right before and after the one write that changes which slot starts, and elsewhere.
std::vector<std::size_t> CutPoints(Scene& scene, std::size_t entries, std::size_t decides) {
  std::vector<std::size_t> points{decides, decides + 1};
  const int others = kUpdateCuts - 2;
  for (int n = 0; n < others; ++n) points.push_back(CutPoint(scene, 0, entries, n, others));
  std::ranges::sort(points);
  return points;
}

// The power went after some of the writes of the update, and a face comes: of the slot before, until the one write that decides.
Result<void> CutUpdate(Scene& scene, UpdateHistory& history, const UpdatedPc& pc) {
  if (auto ok = WantNothingAstray(scene, history); !ok) return ok;
  const auto decision = pc.DecidingSector();
  if (!decision) return tl::unexpected(decision.error());
  const std::size_t decides = history.FirstInto(*decision);
  if (auto ok = WantOneDecision(history, pc, *decision); !ok) return ok;
  auto& counts = scene.finding.counts;
  scene.finding.figures["update_writes"] = static_cast<double>(history.entries());
  counts["boots_without_face"] = 0;
  for (const std::size_t point : CutPoints(scene, history.entries(), decides)) {
    if (auto ok = history.CutAfter(point, pc); !ok) return ok;
    // The update is one of the same system.
    if (point == decides)
      if (auto ok = WantWholeSlotB(pc.Disk(), scene.target.machine().options().image); !ok) return ok;
    const char named = pc.Default(), wanted = point <= decides ? 'a' : 'b';
    if (named != wanted)
      return FailInput(fmt::format("after write {} of {} slot {} starts by itself, and {} should", point,
                                   history.entries(), named, wanted));
    counts["boots_after_cut"] += 1;
    auto ok = pc.Start(scene);
    if (ok) ok = AwaitUpdateFace(scene, "after a cut in the update");
    scene.target.machine().Off();
    if (ok) continue;
    counts["boots_without_face"] += 1;
    return FailInput(fmt::format("no face after a cut behind write {} of {}", point, history.entries()));
  }
  return {};
}

// The data partition alone, of a disk that loses and tears what was not flushed: many more cuts than machines could be started for.
Result<void> CutItsData(Scene& scene, const UpdateHistory& history) {
  const auto cuts = CutData(scene, history, history.Disk(), kDataCuts, false);
  if (!cuts) return tl::unexpected(cuts.error());
  auto& counts = scene.finding.counts;
  counts["data_cuts"] = cuts->cuts;
  counts["data_cuts_wrong"] = cuts->wrong;
  counts["data_cuts_deciding"] = cuts->deciding;
  if (cuts->wrong > 0) return FailInput(cuts->said);
  if (cuts->deciding == 0) return FailInput("no cut falls between two states of what the box keeps");
  for (int n = 0; n < kMostLies; n += kLiesAtOnce) {
    const auto lies = CutData(scene, history, history.Disk(), kLiesAtOnce, true);
    if (!lies) return tl::unexpected(lies.error());
    if (lies->wrong > 0) return {};
  }
  return FailInput("a disk that loses what it said was safe is not found");
}

// Its face was seen for a minute, and all that tells of a try is gone.
Result<void> AwaitConfirmed(Scene& scene, const UpdatedPc& pc) {
  auto ok = pc.StartNoted(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of the update");
  if (ok && pc.Default() != 'a') ok = FailInput("the update is confirmed before its face was looked at");
  const auto gone = [&](const std::string& kept) { return kept.empty() && pc.Default() == 'b'; };
  if (ok) ok = AwaitKept(scene, pc, "update/pending", gone, kLongestTrial);
  if (ok) ok = scene.ShootFace("update", "The face of the update, which stays");
  scene.target.machine().Off();
  return ok;
}

// Brings an update in, and sees it stay: its history, kept for the rounds after this one.
Result<UpdateHistory> BringIn(Scene& scene) {
  auto pc = PcToUpdate(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto history = UpdateHistory::Begin(scene, *pc);
  if (!history) return history;
  auto ok = UpdateAndRestart(scene, *pc);
  if (ok) ok = history->Add(*pc);
  if (ok) ok = AwaitConfirmed(scene, *pc);
  if (ok) ok = history->Add(*pc);
  if (!ok) return tl::unexpected(ok.error());
  history->Keep();
  scene.finding.said = fmt::format("an update by stick was brought in within {:.0f} s, tried, and stays; ",
                                   scene.finding.figures["update_install_s"]);
  return history;
}

// The history that a round before has kept, or that of an update now.
Result<UpdateHistory> HistoryOfAnUpdate(Scene& scene) {
  auto kept = UpdateHistory::Kept(scene);
  if (!kept) return tl::unexpected(kept.error());
  if (*kept) return std::move(**kept);
  return BringIn(scene);
}

// The PC that is cut may be a new one: it gets disk and variables as they stood at the cut.
Result<void> Update(Scene& scene) {
  auto history = HistoryOfAnUpdate(scene);
  if (!history) return tl::unexpected(history.error());
  const auto pc = UpdatedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto ok = CutItsData(scene, *history);
  if (ok) ok = CutUpdate(scene, *history, *pc);
  scene.finding.said += fmt::format(
      "a face came after each of {:.0f} cuts in the {:.0f} writes of an update; {:.0f} cuts that lost and "
      "tore writes spoilt nothing of the data",
      scene.finding.counts["boots_after_cut"], scene.finding.figures["update_writes"],
      scene.finding.counts["data_cuts"]);
  return ok;
}

// Where no update was brought in slot B shows no face: otherwise one that wrote nothing would seem to have come.
Result<void> WithoutAnUpdateSlotBIsDead(Scene& scene) {
  const auto pc = PcToUpdate(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto ok = pc->NameDefault('b');
  if (ok) ok = pc->Start(scene);
  if (ok && AwaitUpdateFace(scene, "of a slot that nobody wrote", kNoFaceOfB))
    ok = FailInput("slot B shows a face although no update was brought in");
  scene.target.machine().Off();
  return ok;
}

// What is spoilt is spoilt by the host between two starts, behind the back of the box that read everything back.
//
// The control: an update whose root is not what its kernel wants gives way within one start.
Result<void> ABadUpdateGivesWay(Scene& scene) {
  if (auto dead = WithoutAnUpdateSlotBIsDead(scene); !dead) return dead;
  auto pc = RestartedPc(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto ok = pc->SpoilSlotB();
  if (ok) ok = pc->Start(scene);
  const auto ended = [&] { return !scene.target.machine().runs(); };
  if (ok && !scene.target.Until(ended, kLongestUpdateStart))
    ok = FailInput("the spoilt slot does not start again");
  scene.target.machine().Off();
  if (ok) ok = pc->Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of the slot before");
  if (ok && pc->Default() != 'a') ok = FailInput("a spoilt slot was confirmed");
  if (ok && !pc->Kept("update/pending").ends_with(" B 1\n"))
    ok = FailInput("the try that gave way is not kept");
  if (ok) ok = scene.ShootFace("update-back", "The slot before is back");
  scene.target.machine().Off();
  return ok;
}

}  // namespace

std::vector<Check> UpdateChecks() {
  return {{.name = "update",
           .sentence =
               "An update that a stick brings is tried once, and stays when its face was seen for a minute",
           .run = Update,
           .setup = {.plugged = false, .sound = false, .agent = false},  // As DiskChecks, which come before.
           .control = ABadUpdateGivesWay,
           .powers = true,
           .most_rounds = kManyRounds,
           .stick = "update"}};
}

}  // namespace kaori::hil
