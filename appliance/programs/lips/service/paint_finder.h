// Finds the paint without a click: it is the patch that differs most from the face around it.
#pragma once

#include <optional>

#include "appliance/programs/lips/contour.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// Returns a point, in parts of the picture from its left top corner, in the largest connected patch near the
// middle of the picture that has a saturated colour other than the skin's. Clothes and walls reach the
// picture's edge and do not count. Nothing where there is no such patch. Pure; it allocates. Runs only when
// somebody asks for it.
std::optional<Point> FindPaint(const decode::Planes& planes);

}  // namespace kaori::lips
