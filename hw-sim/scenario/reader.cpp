#include "hw-sim/scenario/reader.h"

#include <optional>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/scenario/speech.h"
#include "hw-sim/scenario/statements.h"

namespace kaori::sim {
namespace {

// Hours of recording; beyond it the file is something else.
constexpr std::size_t kMostBytes = 64u << 20;
// A file that is no scenario is wrong in every line: nobody reads on.
constexpr std::size_t kMostProblems = 100;

// at 2.5s and over 800ms, in any order, before the statement and behind it. False: a problem was added.
bool ReadTimes(Tokenizer& tokens, Statement& statement) {
  for (;;) {
    auto* const time = tokens.Accept("at")     ? &statement.at
                       : tokens.Accept("over") ? &statement.over
                                               : nullptr;
    if (time == nullptr) return !tokens.bad();
    const int column = tokens.last_column();
    if (*time) {
      tokens.Complain(column, "a second time of the same kind in one line");
      return false;
    }
    *time = tokens.TimeSpan();
  }
}

// Whether the statement has the times that it needs, and none that it cannot have.
bool TimesFit(Tokenizer& tokens, const Statement& statement, int column) {
  const bool takes_time =
      statement.say || (!statement.steps.empty() && MayTakeTime(statement.steps[0].action.verb));
  if (!statement.at && !statement.scene)
    tokens.Complain(column, "when? A line begins with its time, such as at 2.5s");
  if (statement.over && !takes_time)
    tokens.Complain(column,
                    "this happens at once: over is for dial, move, twist, slide, pointer, lips and say");
  if (statement.say && (!statement.over || *statement.over == Duration::zero()))
    tokens.Complain(column, "say wants a time to speak in, such as over 2s");
  return !tokens.bad();
}

// The lines read so far, and the scenario that they make. Statements come in the
// order of the file; times need not.
class Script {
 public:
  void ReadLine(std::string_view line, int number) {
    Tokenizer tokens(line, number, reading_.problems);
    if (tokens.AtEnd()) return;
    Statement statement;
    if (!ReadTimes(tokens, statement)) return;
    const int column = tokens.next_column();
    if (!ReadStatement(tokens, statement) || !ReadTimes(tokens, statement)) return;
    if (!tokens.AtEnd())
      return tokens.Complain(tokens.next_column(), "nothing more is expected in this line");
    if (TimesFit(tokens, statement, column)) Add(statement);
  }

  bool lost() const { return reading_.problems.size() >= kMostProblems; }

  Reading Finish() {
    // Scenes at the end of the file begin with the last line that had a time.
    OpenScenes(reading_.scenario.actions.empty() ? Duration{} : last_at_);
    PutInOrder(reading_.scenario);
    return std::move(reading_);
  }

 private:
  void Add(const Statement& statement) {
    if (statement.scene && !statement.at) {
      waiting_scenes_.push_back(*statement.scene);
      return;
    }
    last_at_ = *statement.at;
    OpenScenes(last_at_);
    if (statement.scene) reading_.scenario.beats.push_back({last_at_, *statement.scene});
    auto& actions = reading_.scenario.actions;
    for (const Step& step : statement.steps)
      actions.push_back({last_at_ + step.after, statement.over.value_or(Duration{}), step.action});
    if (!statement.say) return;
    const auto spoken = Speak(*statement.say, last_at_, *statement.over);
    actions.insert(actions.end(), spoken.begin(), spoken.end());
  }

  // Scenes that were named without a time begin at `at`.
  void OpenScenes(Duration at) {
    for (std::string& name : waiting_scenes_) reading_.scenario.beats.push_back({at, std::move(name)});
    waiting_scenes_.clear();
  }

  Reading reading_;
  std::vector<std::string> waiting_scenes_;  // Named, and begin with the next line that has a time.
  Duration last_at_{};
};

}  // namespace

// Goes on behind a line with a fault, so that one reading tells all faults, up to a limit.
Reading ReadScenario(std::string_view text) {
  Script script;
  int number = 1;
  while (!text.empty() && !script.lost()) {
    const auto end = text.find('\n');
    script.ReadLine(text.substr(0, end), number++);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return script.Finish();
}

std::string Describe(const std::vector<Problem>& problems, std::string_view file) {
  std::string lines;
  for (const Problem& problem : problems) {
    lines += fmt::format("{}{}:{}:{}: {}", lines.empty() ? "" : "\n", file, problem.line, problem.column,
                         problem.what);
  }
  return lines;
}

Result<Scenario> LoadScenario(const std::string& path) {
  const auto text = ReadFile(path, {.most_bytes = kMostBytes});
  if (!text) return tl::unexpected(text.error());
  Reading reading = ReadScenario(*text);
  if (!reading.problems.empty()) return FailInput(Describe(reading.problems, path));
  return std::move(reading.scenario);
}

}  // namespace kaori::sim
