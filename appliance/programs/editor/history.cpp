#include "appliance/programs/editor/history.h"

#include <utility>

namespace kaori::editor {

// The first step is fresh, so that before() always has one to stop at.
void History::Begin(Work work) {
  steps_.clear();
  steps_.push_back({std::move(work), true});
  at_ = 0;
}

// What was undone is dropped: there is one line of steps, and no tree.
void History::Push(Work work, bool fresh) {
  steps_.resize(at_ + 1);
  steps_.push_back({std::move(work), fresh});
  ++at_;
}

void History::Replace(Work work) {
  steps_[at_].work = std::move(work);
}

bool History::Undo() {
  if (undoable() == 0) return false;
  --at_;
  return true;
}

bool History::Redo() {
  if (redoable() == 0) return false;
  ++at_;
  return true;
}

// From the step at which the work was begun to the last one that belongs to it, those that were undone
// included.
void History::Rename(const Work& like) {
  std::size_t end = at_ + 1;
  while (end < steps_.size() && !steps_[end].fresh) ++end;
  for (std::size_t i = Start(); i < end; ++i) {
    steps_[i].work.name = like.name;
    steps_[i].work.slot = like.slot;
  }
}

const Work& History::before() const {
  return steps_[Start()].work;
}

std::size_t History::Start() const {
  std::size_t start = at_;
  while (start > 0 && !steps_[start].fresh) --start;
  return start;
}

}  // namespace kaori::editor
