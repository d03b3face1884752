// The skin: the triangles of the fine mesh that an audience sees of a face at rest, its eyes open, its mouth
// shut.
#pragma once

#include <span>
#include <vector>

#include "render/face/composer.h"

namespace kaori::inspect {

// By triangle of the fine mesh: true where it is seen from one of seven sides, its front to the viewer.
// Inside the mouth, behind the lids and inside the neck there is none. `at_rest` is the shape of one face
// without expression; other faces have a skin of their own.
std::vector<bool> FindSkin(const face::Shape& at_rest, std::span<const face::Triangle> triangles);

}  // namespace kaori::inspect
