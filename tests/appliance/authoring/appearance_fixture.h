// A cast that is sculpted and dressed once for all tests of the appearance, from the default show.
#pragma once

#include <filesystem>

#include "render/face/cast.h"

namespace kaori::appearance {

// The authoring folder of the default show.
std::filesystem::path ShowFolder();

// Sculpted only.
const face::Cast& SculptedCast();

// Sculpted and dressed, with small textures.
const face::Cast& DressedCast();

}  // namespace kaori::appearance
