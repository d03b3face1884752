// The appearance of a cast: sculpted faces are painted, combed and dressed.
#pragma once

#include <filesystem>

#include "drivers/base/result.h"
#include "render/face/cast.h"

namespace kaori::appearance {

// Smaller ones make tests quick; packs are made with these.
struct DressOptions {
  int texture_px = 1024;      // A power of two, 64 .. 4096.
  int shade_directions = 72;  // More are smoother, and slower.
};

// Run after Sculpt. Reads show_folder/looks/<face>.toml for each face and fills of `cast`: the textures, the
// props (hair, teeth, tongue, clothes) with their shade, and each face's occlusion, eye look, surface look
// and list of props; what was there of these is replaced. Single-threaded, some seconds. A fault of a file
// names file, line, item and reason; `cast` is then partly dressed and of no use.
Result<void> Dress(const std::filesystem::path& show_folder, face::Cast& cast,
                   const DressOptions& options = {});

}  // namespace kaori::appearance
