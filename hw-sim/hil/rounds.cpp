#include "hw-sim/hil/rounds.h"

#include <algorithm>
#include <utility>

#include "hw-sim/hil/kept_report.h"

namespace kaori::hil {
namespace {

// The finding of the check of that name; nothing found yet where there is none.
ReportedCheck FoundOf(const Check& check, const std::vector<ReportedCheck>& passes) {
  const auto kept = std::ranges::find(passes, check.name, &ReportedCheck::name);
  return kept != passes.end() ? *kept : ReportedCheck{check.name, check.sentence, {}};
}

void Keep(const ReportedCheck& found, std::vector<ReportedCheck>& passes) {
  const auto kept = std::ranges::find(passes, found.name, &ReportedCheck::name);
  if (kept != passes.end())
    *kept = found;
  else
    passes.push_back(found);
}

// What is kept comes last: a run that is cut between the files does that round again.
Result<void> Write(const Report& report, const std::vector<ReportedCheck>& passes,
                   const RunOptions& options) {
  if (auto ok = WriteReport(report, options.report); !ok) return ok;
  if (!options.figures.empty())
    if (auto ok = MergeFigures(report, options.figures); !ok) return ok;
  return KeepReport(report, passes, options.trial, options.report);
}

}  // namespace

ReportedCheck WithRound(const ReportedCheck& before, const ReportedCheck& round) {
  ReportedCheck found = round;
  found.finding.rounds += before.finding.rounds;
  found.finding.took_s += before.finding.took_s;
  for (const auto& [name, count] : before.finding.counts) found.finding.counts[name] += count;
  for (const auto& [name, value] : before.finding.figures) {
    const auto [at, is_new] = found.finding.figures.try_emplace(name, value);
    if (!is_new) at->second = std::max(at->second, value);
  }
  for (const Picture& picture : before.finding.pictures)
    if (std::ranges::find(round.finding.pictures, picture.caption, &Picture::caption) ==
        round.finding.pictures.end())
      found.finding.pictures.push_back(picture);
  const auto name_of = [](const auto& text) { return text.first; };
  for (const auto& text : before.finding.texts)
    if (std::ranges::find(round.finding.texts, text.first, name_of) == round.finding.texts.end())
      found.finding.texts.push_back(text);
  // It was tried in the first round alone.
  if (found.finding.control.empty()) found.finding.control = before.finding.control;
  return found;
}

// A check stands in the report from its first round on, and is replaced by each further one.
Result<void> RunRounds(std::span<const Check> checks, const RunOptions& options, const RunRound& run,
                       const TellRound& tell, Report& report) {
  auto passes = options.go_on ? KeptPasses(options.trial, options.report) : std::vector<ReportedCheck>();
  for (const Check& check : checks) {
    const int wanted = std::clamp(options.effort, check.least_rounds, check.most_rounds);
    ReportedCheck found = FoundOf(check, passes);
    report.checks.push_back(found);
    if (found.finding.rounds >= wanted) {
      tell(found, wanted, true);
      if (auto ok = Write(report, passes, options); !ok) return ok;
    }
    while (found.finding.verdict == Verdict::kPassed && found.finding.rounds < wanted) {
      found = WithRound(found, run(check, found.finding.rounds));
      if (found.finding.verdict == Verdict::kPassed) Keep(found, passes);
      report.checks.back() = found;
      tell(found, wanted, false);
      if (auto ok = Write(report, passes, options); !ok) return ok;
    }
  }
  return {};
}

}  // namespace kaori::hil
