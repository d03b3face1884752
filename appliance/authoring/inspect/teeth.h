// Teeth through lips: teeth that stand before the skin that should hide them.
#pragma once

#include <vector>

#include "render/face/composer.h"

namespace kaori::inspect {

// What FindTeethThroughLips found; no vertices: no flaw.
struct TeethThroughLips {
  // Vertices of the teeth that stand before the skin.
  int vertices = 0;
  // How far the farthest of them stands out.
  float farthest_m = 0;
};

// Seen from the front: vertices of the teeth that stand 0.3 mm to 2 cm before the skin in their place. `face`
// wears its teeth as the stage draws them in `shape`; `skin` as from FindSkin, of triangles that can move.
// Nothing while the jaw is shut, since the stage then draws no teeth.
TeethThroughLips FindTeethThroughLips(const face::Cast& cast, const face::Face& face,
                                      const face::Shape& shape, const std::vector<bool>& skin);

}  // namespace kaori::inspect
