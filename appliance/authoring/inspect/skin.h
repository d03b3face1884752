// The skin: the triangles of the fine mesh that an audience sees of a face at rest, its eyes open, its mouth
// shut.
#pragma once

#include <span>
#include <vector>

#include "render/face/composer.h"

namespace kaori::inspect {

// By triangle of the fine mesh. Inside the mouth, behind the lids and inside the neck there is none.
std::vector<bool> FindSkin(const face::Shape& at_rest, std::span<const face::Triangle> triangles);

}  // namespace kaori::inspect
