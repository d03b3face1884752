// The power of a PC goes while its firmware is told which slot to try once, and while the loader strikes that again.
#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/power_cuts.h"
#include "hw-sim/hil/update_scene.h"
#include "hw-sim/hil/write_log.h"

namespace kaori::hil {
namespace {

constexpr int kTryCuts = 10;  // In each round.

// The first write that may belong to the variable by which a slot is tried once (systemd's boot loader interface). The firmware writes
// a variable byte by byte, head, name and value, and the log has a sector for each; the name is UTF-16, and may lie in two sectors.
Result<std::size_t> FirstOfTry(const WriteLog& log) {
  constexpr std::size_t kHeadAndName_bytes = 128;
  for (std::size_t n = 0; n < log.entries().size(); ++n) {
    auto content = log.Content(log.entries()[n]);
    if (!content) return tl::unexpected(content.error());
    std::erase(*content, '\0');
    if (content->find("LoaderEntryO") != content->npos || content->find("neShot") != content->npos)
      return n - std::min(n, kHeadAndName_bytes);
  }
  return FailInput("the firmware was not told which slot to try");
}

// What the firmware wrote while the box told it to try slot B, and in the start after that, in which the loader strikes it again.
struct LogsOfTry {
  WriteLog told, struck;
};

// Files beside the PC's folder, which goes with it. Errors: io_error; as RestartedPc and WriteLog::Read; those of the machine.
Result<LogsOfTry> NoteTry(Scene& scene) {
  const std::string& folder = scene.target.machine().options().folder;
  const std::string told = folder + "/try-told.log", struck = folder + "/try-struck.log";
  const auto pc = RestartedPc(scene);
  if (!pc) return tl::unexpected(pc.error());
  std::error_code failed;
  std::filesystem::rename(pc->VariablesLog(), told, failed);
  auto ok = pc->StartNoted(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of a slot that is tried");
  scene.target.machine().Off();
  if (!ok) return tl::unexpected(ok.error());
  if (!failed) std::filesystem::rename(pc->VariablesLog(), struck, failed);
  if (failed) return Fail(std::errc::io_error, "keep what the firmware wrote for a try");
  auto first = WriteLog::Read(told), second = WriteLog::Read(struck);
  if (!first) return tl::unexpected(first.error());
  if (!second) return tl::unexpected(second.error());
  return LogsOfTry{std::move(*first), std::move(*second)};
}

// The disk is each time as the restart left it, with a try that is counted: which slot starts is for the firmware and the loader to say, and
// either has a face. Cuts in turn: while the try is written, into a new PC's variables, and while it is struck from those that were kept.
Result<void> CutTry(Scene& scene, const LogsOfTry& logs, std::size_t first_of_try) {
  auto& counts = scene.finding.counts;
  const int cuts = kTryCuts;
  for (int n = 0; n < cuts; ++n) {
    const bool is_told = n % 2 == 0;
    const WriteLog& log = is_told ? logs.told : logs.struck;
    const std::size_t until =
        CutPoint(scene, is_told ? first_of_try : 0, log.entries().size(), n / 2, (cuts + 1) / 2);
    const auto pc = UpdatedPc::Restarted(scene);
    if (!pc) return FailInput("the PC that is to try its update was not kept");
    Result<void> ok;
    if (is_told) ok = pc->ForgetVariables();
    if (ok) ok = log.Replay(0, until, pc->Variables());
    if (!ok) return ok;
    counts["try_cuts"] += 1;
    if (WantFaceOf(scene, *pc, "after a cut in the variable of a try", kLongestUpdateStart)) continue;
    counts["try_cuts_dead"] += 1;
    return FailInput(
        fmt::format("no face after a cut behind write {} of {} of the firmware, while a try is {}", until,
                    log.entries().size(), is_told ? "written" : "struck"));
  }
  return {};
}

Result<void> TryCuts(Scene& scene) {
  auto& figures = scene.finding.figures;
  scene.finding.counts = {{"try_cuts", 0}, {"try_cuts_dead", 0}};
  const auto logs = NoteTry(scene);
  if (!logs) return tl::unexpected(logs.error());
  const auto first = FirstOfTry(logs->told);
  if (!first) return tl::unexpected(first.error());
  figures["try_writes"] = static_cast<double>(logs->told.entries().size() - *first);
  figures["try_struck_writes"] = static_cast<double>(logs->struck.entries().size());
  if (logs->struck.entries().empty()) return FailInput("nobody struck the try in the start that it was for");
  auto ok = CutTry(scene, *logs, *first);
  scene.finding.said = fmt::format(
      "{:.0f} cuts in the {:.0f} writes by which a try is kept and the {:.0f} by which it is struck left a "
      "face each",
      scene.finding.counts["try_cuts"], figures["try_writes"], figures["try_struck_writes"]);
  return ok;
}

}  // namespace

// It begins with the PC that the check of an update has kept.
std::vector<Check> TryCutChecks() {
  return {
      {.name = "try-cuts",
       .sentence = "A PC whose power goes while its firmware is told which slot to try comes to its face",
       .run = TryCuts,
       .setup = {.plugged = false, .sound = false, .agent = false},  // As UpdateChecks, which come before.
       .control = ASpoiltSlotIsSeen,
       .powers = true,
       .most_rounds = kManyRounds,
       .stick = "update"}};
}

}  // namespace kaori::hil
