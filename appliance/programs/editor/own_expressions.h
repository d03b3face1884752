// The box's own expressions: ten slots, each with its key, in memory as they are on the disk or will be. The
// cast has kSlots expressions for them, whether they are filled or not; the editor renews those when a slot
// changes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "appliance/programs/editor/store.h"
#include "render/face/cast.h"

namespace kaori::editor {

// One thread. A slot is 0 to kSlots - 1; its key is one more, and 0 for the last. What becomes of the files
// is the WorkWriter's business, and the editor's to keep in step.
class OwnExpressions {
 public:
  // `show_names` are those of the show's expressions, which no own expression may have.
  OwnExpressions(Slots slots, std::vector<std::string> show_names)
      : slots_(std::move(slots)), show_names_(std::move(show_names)) {}

  // The expression of a slot; nothing where it is empty. Holds until the slot is changed.
  const std::optional<Work>& at(int slot) const { return slots_[static_cast<std::size_t>(slot)]; }
  // Fills work.slot, which is a valid slot; what was there is replaced.
  void Put(const Work& work) { slots_[static_cast<std::size_t>(work.slot)] = work; }
  // Empties the slot in memory.
  void Empty(int slot) { slots_[static_cast<std::size_t>(slot)].reset(); }
  int free_slot() const;  // The first one; -1: none.

  // Why the work of `slot` (-1: none yet) may not have this name; empty: it may.
  std::string ReasonAgainst(std::string_view name, int slot) const;

  // "1 my_smile  3 wink"; empty: none.
  std::string Contents() const;

 private:
  Slots slots_;
  std::vector<std::string> show_names_;
};

}  // namespace kaori::editor
