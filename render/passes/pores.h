// The fine relief of skin, as a picture that repeats.
#pragma once

#include "render/gl/texture.h"

namespace kaori::passes {

// Pits at uneven distances and a finer grain, worked out anew at each call, always the same: about 10 ms. The
// slope along u and v stands in red and green, 0.5 is none; without a seam at its edges. On the context's thread.
gl::Texture MakePores();

}  // namespace kaori::passes
