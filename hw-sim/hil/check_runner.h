// Tries checks one after another, each on a box that plays, set up as it wants.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/report.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {

// Brings the target into the state that a check wants, runs it, and keeps what helps to find out why it
// failed. One thread: that of the target's waiter.
class CheckRunner {
 public:
  // Options of all checks. `report` and `play` are a folder and a file; the numbers are those of Scene.
  struct Options {
    // The folder.
    std::string report;
    // The file of a scenario; other scenarios lie beside it.
    std::string play;
    // As Scene has them.
    int replugs = 20;
    int scenes = 0;
    // Of Scene::chance.
    std::mt19937::result_type seed = 1;
    // Each check that has passed is followed by its negative control: a check
    // that cannot fail shows nothing.
    bool controls = false;
  };

  // The target outlives the runner. Nothing is switched on yet.
  CheckRunner(Options options, Target& target)
      : options_(std::move(options)), target_(target), strategy_(target) {}

  // Runs one round of a check, and behind the first one its control where that is wanted. A box that crashed in the check before is
  // started anew. What went wrong is in the finding, with the last picture and what the box said.
  // Blocks for minutes. Never fails itself.
  ReportedCheck Run(const Check& check, int round);

  // From power to the first frames of the first box that played; 0: none has.
  double boot_s() const { return boot_s_; }
  // Switches the box off.
  void End() { strategy_.Off(); }

 private:
  // The box plays as the setup says, or an error that is remembered. Errors: those of PlayStrategy::Play.
  Result<void> StartBox(const Setup& setup);
  // Errors: as StartBox. A check that switches by itself finds the box without power.
  Result<void> Prepare(const Check& check);
  // Runs the check alone. Errors: its own; invalid_argument, a program of the box has ended meanwhile that the check does not
  // end itself, on a box that later checks find as it is left.
  Result<void> RunWatched(const Check& check, Scene& scene);
  // Has the scene know how the box's programs stand now. Errors: those of LookAtPrograms.
  Result<void> NotePrograms(const Check& check, Scene& scene);
  // Fails where the control does not find wrong what is wrong, or cannot be tried.
  Result<void> Control(const Check& check, Finding& finding);
  // Fails where the check passes although what it needs was withdrawn, and where the box answers no more: a machine that has
  // ended fails every check.
  Result<void> FailsWithout(const Check& check, Scene& scene);
  // Errors: invalid_argument, the box that the check leaves draws no more, or shows no face; those of the board.
  Result<void> LeavesAFace();
  // Errors: invalid_argument, the kernel of the box has told of a fault of its own since the check before; those of the agent.
  Result<void> WantNoKernelFault();
  // What a check works with, for this finding.
  Scene SceneOf(Finding& finding);
  // Adds the last picture and the logs to the finding; what cannot be had is left out.
  void AddTraces(const std::string& check, Finding& finding);

  Options options_;
  Target& target_;
  // Brings the box to play as each check wants it.
  PlayStrategy strategy_;
  // Seeded anew for each round of a check.
  std::mt19937 chance_;
  // Setups whose box did not start, and why; none is waited for twice.
  std::vector<std::pair<Setup, Error>> failed_setups_;
  // Of the first box that played; 0: none has.
  double boot_s_ = 0;
};

}  // namespace kaori::hil
