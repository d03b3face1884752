#include "appliance/programs/editor/own_expressions.h"

#include <algorithm>

#include <fmt/format.h>

namespace kaori::editor {

int OwnExpressions::free_slot() const {
  const auto free = std::ranges::find_if(slots_, [](const auto& own) { return !own.has_value(); });
  return free == slots_.end() ? -1 : static_cast<int>(free - slots_.begin());
}

// The words follow on "not saved: ".
std::string OwnExpressions::ReasonAgainst(std::string_view name, int slot) const {
  if (!IsName(name)) return "a name is of letters, digits and _, a letter first";
  if (std::ranges::find(show_names_, name) != show_names_.end())
    return fmt::format("\"{}\" is an expression of the show", name);
  for (int other = 0; other < kSlots; ++other)
    if (other != slot && at(other) && at(other)->name == name)
      return fmt::format("\"{}\" is there already", name);
  return {};
}

// The tenth is called by 0.
std::string OwnExpressions::Contents() const {
  std::string contents;
  for (int slot = 0; slot < kSlots; ++slot)
    if (at(slot))
      contents += fmt::format("{}{} {}", contents.empty() ? "" : "  ", (slot + 1) % kSlots, at(slot)->name);
  return contents;
}

}  // namespace kaori::editor
