// From an authoring folder to a show: faces are sculpted, dressed, and given their script.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "appliance/core/show/show.h"
#include "drivers/base/result.h"

namespace kaori::authoring {

// Called before each step with a few words on it: "sculpting the faces ...". On the caller's thread; the
// words are borrowed during the call.
using Progress = std::function<void(std::string_view)>;

// Builds the show that `folder` describes: faces/, expressions.toml, looks/, show.toml and what these name.
// Takes seconds. Single-threaded, and writes no file. Errors: invalid_argument; the attempt lists every fault
// of the first step that has some, one a line, each with file, item and reason.
Result<show::Show> AuthorShow(const std::filesystem::path& folder, const Progress& progress);

}  // namespace kaori::authoring
