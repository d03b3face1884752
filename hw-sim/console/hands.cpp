#include "hw-sim/console/hands.h"

#include <algorithm>

#include <fmt/format.h>

#include "hw-sim/scenario/statements.h"
#include "hw-sim/scenario/words.h"

namespace kaori::console {
namespace {

// A push or a tap would need somebody who lets go later; the page does that itself.
bool IsDoneAtOnce(const sim::Statement& statement) {
  return !statement.say && !statement.scene && statement.steps.size() == 1;
}

void ReadLine(sim::Words& words, std::vector<sim::Hand>& hands) {
  if (words.AtEnd()) return;
  const int column = words.next_column();
  sim::Statement statement;
  if (!sim::ReadStatement(words, statement)) return;
  if (!words.AtEnd()) return words.Complain(words.next_column(), "nothing more is expected in this line");
  if (!IsDoneAtOnce(statement))
    return words.Complain(column, "this takes time: hold and release, press and release");
  hands.push_back(statement.steps[0].hand);
}

}  // namespace

Result<std::vector<sim::Hand>> ReadHands(std::string_view text) {
  std::vector<sim::Hand> hands;
  std::vector<sim::Problem> problems;
  for (int number = 1; !text.empty() && problems.empty(); ++number) {
    const auto end = std::min(text.find('\n'), text.size());
    sim::Words words(text.substr(0, end), number, problems);
    ReadLine(words, hands);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (problems.empty()) return hands;
  return FailInput(fmt::format("{}:{}: {}", problems[0].line, problems[0].column, problems[0].what));
}

}  // namespace kaori::console
