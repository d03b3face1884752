// The default show's cast, where its pack has been built.
#pragma once

#include "render/face/cast.h"

namespace kaori::testing {

// Loaded once; null when there is no pack yet (build the target kaori-show) or it is refused, which `why`
// tells.
const face::Cast* DefaultCast(const char** why = nullptr);

}  // namespace kaori::testing
