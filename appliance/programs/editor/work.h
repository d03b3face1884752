// An expression that an author is working on. A plain value: it is copied into the history, the journal and
// the files.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace kaori::editor {

// How many expressions of its own a box keeps; each has a key.
inline constexpr int kSlots = 10;

// An expression in work. Two of them are equal where all fields are, which is what "unsaved" asks.
struct Work {
  // As face::Expression::displacement: one for each control point, along u, v and outwards of its frame on
  // the reference face.
  std::vector<glm::vec3> pulls_m{};
  std::array<float, 2> lids{};  // Shut by this much: the character's left, right.
  std::string name{};           // Empty: it has none yet.
  std::string origin{};         // The expression that it was begun from.
  int slot = -1;                // Of the own expression that saving replaces; -1: none yet.

  friend bool operator==(const Work&, const Work&) = default;
};

}  // namespace kaori::editor
