// Every step of a session, to go back and forth over. Pure; steps are held whole. A session's history goes
// over several expressions: each that is taken up is one more step, and undo leads back to the one before.
#pragma once

#include <cstddef>
#include <vector>

#include "appliance/programs/editor/work.h"

namespace kaori::editor {

// There is always a step: undoable() of them lie before it, redoable() after it. Steps are held whole: a step
// is some kilobytes, and an evening has hundreds of them. References that it gives hold until the next
// change.
class History {
 public:
  // Forgets all and begins with `work`.
  void Begin(Work work);

  // A new step after the one in work; what was undone is gone. A `fresh` one came from elsewhere: before()
  // does not look behind it.
  void Push(Work work, bool fresh = false);

  // The newest step goes on.
  void Replace(Work work);

  // Each goes one step back or forth.
  bool Undo();  // False: there is nothing to undo.
  bool Redo();  // False: there is nothing to redo.

  // Gives all steps since the work was begun another name and slot: neither is a step.
  void Rename(const Work& like);

  // The step in work.
  const Work& now() const { return steps_[at_].work; }
  const Work& before() const;  // The work as it was begun.
  // Steps before and behind the one in work.
  std::size_t undoable() const { return at_; }
  std::size_t redoable() const { return steps_.size() - 1 - at_; }

 private:
  struct Step {
    Work work;
    // The work came from elsewhere, and not from the steps before it.
    bool fresh = false;
  };
  // The index of the step with which the work was begun.
  std::size_t Start() const;

  std::vector<Step> steps_{1};
  // The step in work; those behind it were undone.
  std::size_t at_ = 0;
};

}  // namespace kaori::editor
