// Reads a show's faces: faces/cast.toml and one file for each face.
#pragma once

#include <filesystem>

#include "appliance/authoring/sculpt/recipe.h"
#include "drivers/base/result.h"

namespace kaori::sculpt {

// `folder` is the show's "faces". Reads cast.toml and NAME.toml for each name in its list. A face may be
// "like" another carved one, whose values stand where it says nothing; that one may be like none. Every fault
// of all files names its file, line, item and reason, one a line. Errors: ReadToml's where cast.toml cannot
// be read, else invalid_argument; also where the first face is not carved.
Result<CastRecipe> ReadCastRecipe(const std::filesystem::path& folder);

}  // namespace kaori::sculpt
