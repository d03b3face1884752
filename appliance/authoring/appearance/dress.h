// The appearance of a cast: sculpted faces are painted, combed and dressed.
#pragma once

#include <filesystem>

#include "drivers/base/result.h"
#include "render/face/cast.h"

namespace kaori::appearance {

// Smaller ones make tests quick; packs are made with these.
struct DressOptions {
  int texture_px = 1024;  // A power of two, 64 .. 4096.
  // Depth pictures that occlusion is measured from. More are smoother, and slower in proportion.
  int shade_directions = 72;
};

// Run after Sculpt. Reads show_folder/looks/<face>.toml for each face and fills of `cast`: the textures (one
// for each face), the props (hair, gear, teeth, tongue, clothes) with their shade, and each face's occlusion,
// eye look, surface look and list of props; what was there of these is replaced. Teeth and tongue are three
// props that all faces share. Single-threaded, some seconds.
//
// Errors: as ReadLook's for the first look with a fault; invalid_argument for a texture size that is no power
// of two from 64 to 4096, or a cast with another topology than the sculptor's. `cast` is then partly dressed
// and of no use.
Result<void> Dress(const std::filesystem::path& show_folder, face::Cast& cast,
                   const DressOptions& options = {});

}  // namespace kaori::appearance
