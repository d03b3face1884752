// What kaori-atelier take does: each action by its name.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/authoring/pack/verb.h"
#include "drivers/base/result.h"

namespace kaori::authoring {

// What is said when it is done.
using Said = Result<std::string>;

// One of them. `run` blocks for the disk, and gets as many words as it asks for and no other options.
struct TakeAction {
  std::string_view name;
  std::string_view words;  // "FOLDER NAME FACTOR".
  std::vector<std::string_view> options;
  Said (*run)(const Arguments& arguments);
};

// In the order in which they are told.
std::span<const TakeAction> ActionsOnTakes();

}  // namespace kaori::authoring
