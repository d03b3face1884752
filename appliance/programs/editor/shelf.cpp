#include "appliance/programs/editor/shelf.h"

#include <algorithm>

#include <fmt/format.h>

namespace kaori::editor {

int Shelf::free_place() const {
  const auto free = std::ranges::find_if(places_, [](const auto& own) { return !own.has_value(); });
  return free == places_.end() ? -1 : static_cast<int>(free - places_.begin());
}

std::string Shelf::Against(std::string_view name, int place) const {
  if (!IsName(name)) return "a name is of letters, digits and _, a letter first";
  if (std::ranges::find(show_names_, name) != show_names_.end())
    return fmt::format("\"{}\" is an expression of the show", name);
  for (int other = 0; other < kPlaces; ++other)
    if (other != place && at(other) && at(other)->name == name)
      return fmt::format("\"{}\" is there already", name);
  return {};
}

std::string Shelf::Contents() const {
  std::string contents;
  for (int place = 0; place < kPlaces; ++place)
    if (at(place))
      contents +=
          fmt::format("{}{} {}", contents.empty() ? "" : "  ", (place + 1) % kPlaces, at(place)->name);
  return contents;
}

}  // namespace kaori::editor
