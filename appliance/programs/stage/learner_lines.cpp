// What learn mode calls its choices, and what it says on the picture.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/programs/stage/learner.h"

namespace kaori::stage {

using board::LearnPhase;

// Levels that every show has, faces and expressions as levels; then what buttons may call; last the turn of a dial.
std::uint32_t Learner::ChoiceCount() const {
  const std::size_t items = own_.items.faces.size() + own_.items.expressions.size();
  return static_cast<std::uint32_t>(show::kNamedLevels + items + calls_.size() + 1);
}

// Behind all others, so that Up from the first choice comes to it.
bool Learner::IsTurn() const {
  return now_.choice + 1 == ChoiceCount();
}

// Calls follow the levels, and the turn is none of them.
bool Learner::IsCall() const {
  return now_.choice >= show::kNamedLevels + own_.items.faces.size() + own_.items.expressions.size() &&
         !IsTurn();
}

// As files call it.
std::string Learner::NameOfChoice() const {
  if (IsTurn()) return "one turn of a dial";
  std::size_t choice = now_.choice;
  if (choice < show::kNamedLevels) return std::string(show::kLevels[choice].name);
  choice -= show::kNamedLevels;
  const std::size_t items = own_.items.faces.size() + own_.items.expressions.size();
  if (choice >= items) return calls_[choice - items];
  if (choice < own_.items.faces.size()) return "face " + own_.items.faces[choice];
  return "expression " + own_.items.expressions[choice - own_.items.faces.size()];
}

// What it went is shown as the board counts it, which is what the device itself counts where no file and no lesson
// says otherwise.
std::vector<std::string> Learner::LinesOfTurn() const {
  std::vector<std::string> lines{"teach: how many counts has one turn of a dial?"};
  const std::string dial = board::NameOf(now_.found);
  switch (now_.phase) {
    case LearnPhase::kFound:
    case LearnPhase::kRefused:
      lines.push_back(fmt::format("{} went {} counts: was it one whole turn?", dial, now_.turn_counts));
      if (now_.phase == LearnPhase::kRefused) lines.emplace_back("it could not be kept; see the log");
      lines.emplace_back("Enter keeps it   turn once more: measured anew   Esc ends");
      return lines;
    case LearnPhase::kKeeping:
      lines.push_back(dial + " is being kept");
      return lines;
    case LearnPhase::kKept:
      lines.push_back(dial + " is kept, and so are the other dials of its device");
      lines.emplace_back("Up, Down: another   Esc ends");
      return lines;
    default:
      break;
  }
  if (now_.ambiguous != 0) lines.emplace_back("two at once: turn one alone");
  lines.emplace_back("turn one dial once around, and let it stand   Up, Down: another   Esc ends");
  return lines;
}

// Each phase says what is to be done next; what hinders the search stands between.
std::vector<std::string> Learner::Lines() const {
  if (IsTurn()) return LinesOfTurn();
  std::vector<std::string> lines{
      fmt::format("teach: what {} {}?", IsCall() ? "calls" : "plays", NameOfChoice())};
  const std::string control = board::NameOf(now_.found);
  switch (now_.phase) {
    case LearnPhase::kFound:
    case LearnPhase::kRefused:
      lines.push_back(control + (now_.inverted != 0 ? ", inverted" : ""));
      if (now_.instead != 0) lines.push_back(fmt::format("instead of {}", fmt::join(instead_, ", ")));
      if (now_.phase == LearnPhase::kRefused) lines.emplace_back("it could not be kept; see the log");
      lines.emplace_back(IsCall() ? "Enter keeps it   Esc ends"
                                  : "Enter keeps it   Left, Right turn it round   Esc ends");
      return lines;
    case LearnPhase::kUnfit:
      lines.push_back(control + " springs back, and this level rests at an end");
      break;
    case LearnPhase::kKeeping:
      lines.push_back(control + " is being kept");
      return lines;
    case LearnPhase::kKept:
      lines.push_back(control + " is kept");
      lines.emplace_back("Up, Down: another   Esc ends: the stage starts again with it");
      return lines;
    case LearnPhase::kNever:
    case LearnPhase::kAsking:
    case LearnPhase::kEnded:
      break;
  }
  if (now_.restless != 0) lines.push_back(board::NameOf(now_.moves_itself) + " does not rest");
  if (now_.ambiguous != 0) lines.emplace_back("two at once: move one alone");
  lines.push_back(
      fmt::format("{}   Up, Down: another   Esc ends", IsCall() ? "push a button" : "move a control"));
  return lines;
}

}  // namespace kaori::stage
