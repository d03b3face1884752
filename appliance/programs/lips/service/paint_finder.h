// Where the paint is, without anybody's click: the patch that is least like the face round it.
#pragma once

#include <optional>

#include "appliance/programs/lips/outline.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// A place in the largest coherent patch of a saturated colour that is not the skin's, near the middle of the
// picture; in parts of the picture, from the left top. Clothes and walls reach the picture's edge: they are
// none.
std::optional<Point> FindPaint(const decode::Planes& planes);

}  // namespace kaori::lips
