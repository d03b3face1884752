// What the editor writes into the picture's lower left corner.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "appliance/programs/editor/input.h"
#include "appliance/programs/editor/session.h"

namespace kaori::editor {

// Borrowed for the call.
struct CaptionFacts {
  const Session& session;
  // The chosen control point; -1: none.
  int chosen = -1;
  const std::optional<Typing>& typing;
  // The work is shown as it was begun, while a key is held.
  bool comparing = false;
  bool help = true;     // All keys, or how to see them.
  std::string own;      // The own expressions and their keys.
  std::string message;  // Of the last seconds; empty: none.
  std::string trouble;  // With the disk; empty: none.
};

// The lines from top to bottom, in ASCII. Pure, and the same facts give the same lines; allocates.
std::vector<std::string> CaptionLines(const CaptionFacts& facts);

}  // namespace kaori::editor
