// How the needles' work gets its name and its place, and is kept.
#include "appliance/programs/editor/expression_editor.h"

#include <utility>

#include <fmt/format.h>

#include "drivers/base/log.h"

namespace kaori::editor {
namespace {

constexpr Duration kSure = std::chrono::seconds(3);  // Within which Delete is pressed again.

}  // namespace

void ExpressionEditor::Save(bool as_new) {
  const Work& work = session_.work();
  if (as_new) return input_.AskForName(Typing::For::kSaveAsNew, "");
  if (work.name.empty()) return input_.AskForName(Typing::For::kSave, "");
  NameAndSave(work.name, false);
}

void ExpressionEditor::NameAndSave(const std::string& name, bool as_new) {
  const int own = as_new ? -1 : session_.work().place;
  const auto purpose = as_new ? Typing::For::kSaveAsNew : Typing::For::kSave;
  if (std::string against = shelf_.Against(name, own); !against.empty()) {
    Say("not saved: " + against);
    return input_.AskForName(purpose, name);
  }
  const int place = own >= 0 ? own : shelf_.free_place();
  if (place < 0) return Say("not saved: all ten places are taken; delete one");
  Did(session_.Rename(name, place));
  shelf_.Put(session_.work());
  renewed_.push_back({this->own(place), &*shelf_.at(place)});
  scribe_.Save(session_.work());
  Say(fmt::format("{} is called by Shift+{}", name, (place + 1) % kPlaces));
}

void ExpressionEditor::Name(const std::string& name) {
  if (std::string against = shelf_.Against(name, session_.work().place); !against.empty()) {
    Say("not named: " + against);
    return input_.AskForName(Typing::For::kName, name);
  }
  Did(session_.Rename(name, session_.work().place));
}

// What was deleted stays in work, unsaved: it can be saved again.
void ExpressionEditor::Delete(Time now) {
  const Work work = session_.work();
  if (work.place < 0) return Say("it is not on the box: nothing to delete");
  if (now > delete_until_) {
    delete_until_ = now + kSure;
    return Say(fmt::format("press Delete again to delete {}", work.name));
  }
  delete_until_ = {};
  shelf_.Empty(work.place);
  scribe_.Remove(work);
  Did(session_.Rename(work.name, -1));
}

void ExpressionEditor::HearNews() {
  for (const News& news : scribe_.DrainNews()) {
    switch (news.kind) {
      case News::Kind::kSaved:
        Log("expression {} is saved as the box's own {}", news.work.name, news.work.place + 1);
        Did(session_.Keep(news.work));
        break;
      case News::Kind::kRemoved:
        Log("expression {} is deleted", news.work.name);
        break;
      case News::Kind::kFailing:
        LogWarning("the needles cannot keep their work: {}; it goes on in memory and is tried again", news.text);
        trouble_ = news.text;
        break;
      case News::Kind::kWorking:
        Log("the needles' work is on the disk again");
        trouble_.clear();
        break;
    }
  }
}

}  // namespace kaori::editor
