// A face of a cast as a file for a modelling tool.
#pragma once

#include <cstddef>
#include <string>

#include "render/face/cast.h"

namespace kaori::import {

// Wavefront OBJ: the skin as the polygons that the wireframe shows, each place once though a seam of the texture parts it, and
// both eyeballs as objects of their own, whose texture coordinates lie in sculpt::kEyeTile. Metres, +Y up, +Z out of the
// face. A face on the default show's mesh comes back by sculpt::ReadModelledHead. `face` is an index of
// cast.faces; an eye without a ball is left out. Numbers have six decimals: a thousandth of a millimetre.
std::string ObjOfFace(const face::Cast& cast, std::size_t face);

}  // namespace kaori::import
