// The statements of a scenario's line: words into actions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hw-sim/scenario/scenario.h"
#include "hw-sim/scenario/tokenizer.h"

namespace kaori::sim {

// One action of a statement; a push has two.
struct Step {
  Duration after{};  // After the line's time.
  // What is done then.
  OperatorAction action;
};

// One line: its times and exactly one of the others. A reader that finds a fault leaves it half filled.
struct Statement {
  // When, and for how long; both may be missing.
  std::optional<Duration> at;
  std::optional<Duration> over;
  // What the line does; none for a scene or a speech.
  std::vector<Step> steps;
  // Syllables.
  std::optional<std::string> say;
  // The name of a scene that begins.
  std::optional<std::string> scene;
};

// Reads from the statement's first word to its last one, without the times before and behind it. False:
// a problem was added to the tokenizer's. Words are checked against the devices' own ranges.
bool ReadStatement(Tokenizer& tokens, Statement& into);

}  // namespace kaori::sim
