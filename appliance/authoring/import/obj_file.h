// Reads Wavefront OBJ with texture coordinates.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "appliance/authoring/import/findings.h"
#include "appliance/authoring/import/model.h"

namespace kaori::import {

// One vertex for each pair of position and texture coordinate that a triangle uses, in the order of the
// positions and then of the coordinates, so that files of equal order give equal vertices. Polygons are
// split; materials and normals are left out. Every fault goes to `findings` under the name `file`.
std::optional<Model> ReadObj(const std::string& file, std::span<const std::uint8_t> bytes,
                             Findings& findings);

}  // namespace kaori::import
