// The sculptor: from the files of a show to the geometry of its cast.
#pragma once

#include <filesystem>

#include "drivers/base/result.h"
#include "render/face/cast.h"

namespace kaori::sculpt {

// Reads show_folder/faces/*.toml and show_folder/expressions.toml and fills of `cast`: the topology, the
// control net, the expressions, each face's name, positions, eyes, mouth fit and expression gain, the pivots.
// What appearance::Dress decides (textures, looks, hair, occlusion) is left as it is; faces are replaced.
//
// Single-threaded, a fraction of a second; the same files give the same cast. Errors: as ReadCastRecipe's,
// ReadExpressionFile's and those of shaping; file, line, item and reason. `cast` is then unchanged.
Result<void> Sculpt(const std::filesystem::path& show_folder, face::Cast& cast);

}  // namespace kaori::sculpt
