// Tries checks one after another, each on a box that plays, set up as it wants.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/report.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {

class Trial {
 public:
  struct Options {
    std::string report;  // The folder.
    std::string play;
    int replugs = 20;
    int scenes = 0;
    std::mt19937::result_type seed = 1;
  };

  // The place outlives the trial.
  Trial(Options options, Place& place)
      : options_(std::move(options)), place_(place), strategy_(place), chance_(options_.seed) {}

  // A box that the check before has felled is started anew. What went wrong is in the finding, with the last
  // picture and what the box said.
  ReportedCheck Try(const Check& check);

  double boot_s() const { return boot_s_; }  // Of the first box; 0: none has played.
  void End() { strategy_.Off(); }

 private:
  Result<void> StartBox(const Setup& setup);
  Result<void> Run(const Check& check, Finding& finding);
  void AddTraces(const std::string& check, Finding& finding);

  Options options_;
  Place& place_;
  PlayStrategy strategy_;
  std::mt19937 chance_;
  std::vector<std::pair<Setup, Error>> dead_;  // Setups whose box did not start; none is waited for twice.
  double boot_s_ = 0;
};

}  // namespace kaori::hil
