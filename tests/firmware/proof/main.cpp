// Runs all proofs and prints what was wrong: for the builds that are wrong on purpose.
#include <cstdio>
#include <cstdlib>

#include "tests/firmware/proof/flash_proof.h"
#include "tests/firmware/proof/proofs.h"

int main() {
  using namespace kaori::proof;
  const auto dials = ProveDials(200'000, 1);
  const auto buttons = ProveButtons(2'000, 8, 2);
  const auto spikes = ProveButtons(2'000, 0, 2);
  const auto axes = ProveAxes(50, 3);
  const auto reports = ProveReports(200'000, 4);
  const auto cuts = ProveCuts(1);
  const auto defects = ProveDefects(200);
  const auto trials = ProveTrials(20);
  std::printf(
      "dials %llu, double steps %llu, buttons %llu, axes %llu, reports %llu, cuts %llu, defects %llu, trials "
      "%llu\n",
      static_cast<unsigned long long>(dials.counts_lost),
      static_cast<unsigned long long>(dials.double_steps_untold),
      static_cast<unsigned long long>(buttons.wrong + spikes.wrong),
      static_cast<unsigned long long>(axes.wrong + axes.reports_at_rest),
      static_cast<unsigned long long>(reports.wrong),
      static_cast<unsigned long long>(cuts.dead + cuts.unexpected + cuts.lost),
      static_cast<unsigned long long>(defects), static_cast<unsigned long long>(trials));
  const bool wrong = dials.counts_lost + dials.double_steps_untold + buttons.wrong + spikes.wrong +
                         axes.wrong + axes.reports_at_rest + reports.wrong + cuts.dead + cuts.unexpected +
                         cuts.lost + defects + trials !=
                     0;
  return wrong ? EXIT_FAILURE : EXIT_SUCCESS;
}
