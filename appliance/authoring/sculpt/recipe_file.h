// Reads a show's faces: faces/cast.toml and one file for each face.
#pragma once

#include <filesystem>

#include "appliance/authoring/sculpt/recipe.h"
#include "drivers/base/result.h"

namespace kaori::sculpt {

// `folder` is the show's "faces". Every fault names its file, line, item and reason.
Result<CastRecipe> ReadCastRecipe(const std::filesystem::path& folder);

}  // namespace kaori::sculpt
