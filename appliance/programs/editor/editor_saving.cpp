// How the author's work gets its name and its slot, and is kept.
#include "appliance/programs/editor/expression_editor.h"

#include <utility>

#include <fmt/format.h>

#include "drivers/base/log.h"

namespace kaori::editor {
namespace {

constexpr Duration kSure = std::chrono::seconds(3);  // Within which Delete is pressed again.

}  // namespace

// Work without a name asks for one first and is saved when it is typed.
void ExpressionEditor::Save(bool as_new) {
  const Work& work = session_.work();
  if (as_new) return input_.AskForName(Typing::For::kSaveAsNew, "");
  if (work.name.empty()) return input_.AskForName(Typing::For::kSave, "");
  NameAndSave(work.name, false);
}

// The slot in memory is filled at once, so that its key calls the expression in the next frame; that it is on
// the disk is told by an outcome later. A name that is refused is asked for again with what was typed.
void ExpressionEditor::NameAndSave(const std::string& name, bool as_new) {
  const int own = as_new ? -1 : session_.work().slot;
  const auto purpose = as_new ? Typing::For::kSaveAsNew : Typing::For::kSave;
  if (std::string against = own_.ReasonAgainst(name, own); !against.empty()) {
    Say("not saved: " + against);
    return input_.AskForName(purpose, name);
  }
  const int slot = own >= 0 ? own : own_.free_slot();
  if (slot < 0) return Say("not saved: all ten slots are in use; delete one");
  Did(session_.Rename(name, slot));
  own_.Put(session_.work());
  renewed_.push_back({this->own(slot), &*own_.at(slot)});
  writer_.Save(session_.work());
  Say(fmt::format("{} is called by Shift+{}", name, (slot + 1) % kSlots));
}

// The work keeps its slot: a name alone saves nothing.
void ExpressionEditor::Name(const std::string& name) {
  if (std::string against = own_.ReasonAgainst(name, session_.work().slot); !against.empty()) {
    Say("not named: " + against);
    return input_.AskForName(Typing::For::kName, name);
  }
  Did(session_.Rename(name, session_.work().slot));
}

// What was deleted stays in work, unsaved: it can be saved again.
void ExpressionEditor::Delete(Time now) {
  const Work work = session_.work();
  if (work.slot < 0) return Say("it is not on the box: nothing to delete");
  if (now > delete_until_) {
    delete_until_ = now + kSure;
    return Say(fmt::format("press Delete again to delete {}", work.name));
  }
  delete_until_ = {};
  own_.Empty(work.slot);
  writer_.Remove(work);
  Did(session_.Rename(work.name, -1));
}

// The work counts as saved only now, as it was when it was written: an author who pulled on meanwhile has
// unsaved work.
void ExpressionEditor::HandleOutcomes() {
  for (const Outcome& outcome : writer_.DrainOutcomes()) {
    switch (outcome.kind) {
      case Outcome::Kind::kSaved:
        Log("expression {} is saved as the box's own {}", outcome.work.name, outcome.work.slot + 1);
        Did(session_.Keep(outcome.work));
        break;
      case Outcome::Kind::kRemoved:
        Log("expression {} is deleted", outcome.work.name);
        break;
      case Outcome::Kind::kFailing:
        LogWarning("the needles cannot keep their work: {}; it goes on in memory and is tried again",
                   outcome.text);
        trouble_ = outcome.text;
        break;
      case Outcome::Kind::kWorking:
        Log("the needles' work is on the disk again");
        trouble_.clear();
        break;
    }
  }
}

}  // namespace kaori::editor
