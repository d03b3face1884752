// Reads show.toml: what each control of the operators calls up.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "appliance/core/show/show.h"

namespace kaori::authoring {

// Fills buttons, motions, scenes and channels of `show`, whose cast must be there: names are looked up in it.
// Returns every fault found, one line each: file, item, reason; empty when all is well.
std::vector<std::string> ReadShowFile(const std::filesystem::path& file, show::Show& show);

}  // namespace kaori::authoring
