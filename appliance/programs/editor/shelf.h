// The box's own expressions: ten places, each with its key, in memory as they are on the disk or will be.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "appliance/programs/editor/store.h"
#include "render/face/cast.h"

namespace kaori::editor {

class Shelf {
 public:
  // `show_expressions` are the cast's before the box's own; their names are theirs.
  Shelf(Places places, std::vector<std::string> show_names)
      : places_(std::move(places)), show_names_(std::move(show_names)) {}

  const std::optional<Work>& at(int place) const { return places_[static_cast<std::size_t>(place)]; }
  void Put(const Work& work) { places_[static_cast<std::size_t>(work.place)] = work; }
  void Empty(int place) { places_[static_cast<std::size_t>(place)].reset(); }
  int free_place() const;  // The first one; -1: none.

  // Why the work of `place` (-1: none yet) may not have this name; empty: it may.
  std::string Against(std::string_view name, int place) const;

  // "1 my_smile  3 wink"; empty: none.
  std::string Contents() const;

 private:
  Places places_;
  std::vector<std::string> show_names_;
};

}  // namespace kaori::editor
