// Checks round after round, with a report after each, from where a run before was cut.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "drivers/base/result.h"
#include "hw-sim/hil/report.h"

namespace kaori::hil {

// Of a run of checks.
struct RunOptions {
  // The folder that gets the report.
  std::string report;
  // As MergeFigures has it; empty: no file.
  std::string figures;
  // As KeepReport has it.
  std::string trial;
  // How many rounds those checks have that may have more than one.
  int effort = 1;
  // From what the folder's report of this very trial has of each check.
  bool go_on = false;
};

// One round of a check, from 0.
using RunRound = std::function<ReportedCheck(const Check& check, int round)>;
// For whoever waits: what a check has come to, after each of its rounds, of `wanted` in all. `before`: all of it in a run before this one.
using TellRound = std::function<void(const ReportedCheck& check, int wanted, bool before)>;

// What rounds of a check have found so far, with one more: counts add up, of each figure the greatest stands, of pictures and texts for
// people those of the last round that had one, and all else is the last round's. Of a round that has not passed the verdict and the reason stand. Pure.
ReportedCheck WithRound(const ReportedCheck& before, const ReportedCheck& round);

// Runs each check as often as its rounds are wanted, or until one has not passed, and writes the report after each; it has what was
// found until then where this fails. Errors: those of the report's files.
Result<void> RunRounds(std::span<const Check> checks, const RunOptions& options, const RunRound& run,
                       const TellRound& tell, Report& report);

}  // namespace kaori::hil
