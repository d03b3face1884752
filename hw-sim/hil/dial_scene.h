// What checks of dials share that are not the box's usual ones: the box's input program with options of a check's own, and
// looks at the board for machines that have little of a processor.
#pragma once

#include <functional>
#include <string>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/paused_unit.h"

namespace kaori::hil {

// How long one wait for a dial lasts at most.
inline constexpr Duration kLongestDial = std::chrono::seconds(90);

// The agent's answer, two minutes at most. Errors: as AgentProtocol::Ask.
Result<std::string> AskOfDials(Scene& scene, const std::string& question);

// The box's input program with options of the check's own, in place of its unit, for a scope.
class StartedInput {
 public:
  // Errors of starting are seen where nothing arrives.
  StartedInput(Scene& scene, const std::string& options);
  ~StartedInput() { End(); }
  StartedInput(const StartedInput&) = delete;
  StartedInput& operator=(const StartedInput&) = delete;

  // Ends it, and gives what it said. Once.
  std::string End();

 private:
  Scene& scene_;
  const PausedUnit unit_;
  std::string number_;
};

// The board must come to be so. Errors: invalid_argument with `what`.
Result<BoardView> WantBoard(Scene& scene, const std::function<bool(const BoardView&)>& right,
                            const std::string& what);

}  // namespace kaori::hil
