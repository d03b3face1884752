// Reads Wavefront OBJ with texture coordinates.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "appliance/authoring/model/findings.h"
#include "appliance/authoring/model/model.h"

namespace kaori::model {

// Objects and groups are the meshes, where each has vertices of its own. One vertex for each pair of position and texture coordinate that a triangle uses, in the order of the
// positions and then of the coordinates, so that files of equal order give equal vertices; vertices that no
// triangle uses fall out. Polygons are split into triangles by the library. Materials, normals, curves and
// all other lines are left out, unread. OBJ says no unit: metres are taken, and CheckModel refuses what is
// not a head's size.
//
// Every fault goes to `findings` under the name `file`: a line of more than 4096 letters, a word that is no
// number, no triangle, corners without a texture coordinate or with one that does not exist, more than
// kMostVertices. None where there was one.
std::optional<Model> ReadObj(const std::string& file, std::span<const std::uint8_t> bytes,
                             Findings& findings);

}  // namespace kaori::model
