#include "hw-sim/console/input.h"

#include <algorithm>

#include <fmt/format.h>

#include "hw-sim/scenario/statements.h"
#include "hw-sim/scenario/tokenizer.h"

namespace kaori::console {
namespace {

// A push or a tap would need somebody who lets go later; the page does that
// itself, by the finger on the screen.
bool IsDoneAtOnce(const sim::Statement& statement) {
  return !statement.say && !statement.scene && statement.steps.size() == 1;
}

// Reads one line; whatever is wrong goes to the tokenizer's problems.
void ReadLine(sim::Tokenizer& tokens, std::vector<sim::OperatorAction>& actions) {
  if (tokens.AtEnd()) return;
  const int column = tokens.next_column();
  sim::Statement statement;
  if (!sim::ReadStatement(tokens, statement)) return;
  if (!tokens.AtEnd()) return tokens.Complain(tokens.next_column(), "nothing more is expected in this line");
  if (!IsDoneAtOnce(statement))
    return tokens.Complain(column, "this takes time: hold and release, press and release");
  actions.push_back(statement.steps[0].action);
}

}  // namespace

Result<std::vector<sim::OperatorAction>> ReadInput(std::string_view text) {
  std::vector<sim::OperatorAction> actions;
  std::vector<sim::Problem> problems;
  // Stops with the first problem: a page's lines are made by its own program, so one fault says enough.
  for (int number = 1; !text.empty() && problems.empty(); ++number) {
    const auto end = std::min(text.find('\n'), text.size());
    sim::Tokenizer tokens(text.substr(0, end), number, problems);
    ReadLine(tokens, actions);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (problems.empty()) return actions;
  return FailInput(fmt::format("{}:{}: {}", problems[0].line, problems[0].column, problems[0].what));
}

}  // namespace kaori::console
