// Teeth through lips: teeth that stand before the skin that should hide them.
#pragma once

#include <vector>

#include "render/face/composer.h"

namespace kaori::inspect {

struct TeethThroughLips {
  int vertices = 0;      // Of the teeth, before the skin.
  float farthest_m = 0;  // How far the farthest stands out.
};

// Seen from the front. `face` wears its teeth as the stage draws them in `shape`; `skin` as from FindSkin.
TeethThroughLips FindTeethThroughLips(const face::Cast& cast, const face::Face& face,
                                      const face::Shape& shape, const std::vector<bool>& skin);

}  // namespace kaori::inspect
