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
  OperatorAction action;
};

// One line: its times and exactly one of the others.
struct Statement {
  std::optional<Duration> at;
  std::optional<Duration> over;
  std::vector<Step> steps;
  std::optional<std::string> say;
  std::optional<std::string> scene;
};

// Reads from the statement's first word to its last one. False: a problem was added to the tokenizer's.
bool ReadStatement(Tokenizer& tokens, Statement& into);

}  // namespace kaori::sim
