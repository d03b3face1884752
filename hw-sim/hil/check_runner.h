// Tries checks one after another, each on a box that plays, set up as it wants.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/report.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {

class CheckRunner {
 public:
  struct Options {
    std::string report;  // The folder.
    std::string play;
    int replugs = 20;
    int scenes = 0;
    std::mt19937::result_type seed = 1;
    bool controls = false;  // Each check that has passed is followed by its negative control.
  };

  // The target outlives the runner.
  CheckRunner(Options options, Target& target)
      : options_(std::move(options)), target_(target), strategy_(target), chance_(options_.seed) {}

  // A box that crashed in the check before is started anew. What went wrong is in the finding, with the last
  // picture and what the box said.
  ReportedCheck Run(const Check& check);

  double boot_s() const { return boot_s_; }  // Of the first box; 0: none has played.
  void End() { strategy_.Off(); }

 private:
  Result<void> StartBox(const Setup& setup);
  Result<void> Prepare(const Check& check);
  Result<void> Control(const Check& check, Finding& finding);
  Result<void> FailsWithout(const Check& check, Scene& scene);
  Scene SceneOf(Finding& finding);
  void AddTraces(const std::string& check, Finding& finding);

  Options options_;
  Target& target_;
  PlayStrategy strategy_;
  std::mt19937 chance_;
  std::vector<std::pair<Setup, Error>>
      failed_setups_;  // Setups whose box did not start, and why; none is waited for twice.
  double boot_s_ = 0;
};

}  // namespace kaori::hil
