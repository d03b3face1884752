// A show as large as the box promises to play, made by formulas.
#pragma once

#include "appliance/core/show/show.h"

namespace kaori::tests {

// 16 faces with a texture each, 40 expressions, and more than 100 000 triangles on a face.
show::Show MakeLargeShow();

}  // namespace kaori::tests
