// The cast of the default show, light enough to be opened many times over.
#pragma once

#include "render/face/cast.h"

namespace kaori::tests {

// The pack's cast with skins of one pixel, and of all that is worn the clothes alone. Fails the program where the
// pack cannot be read.
face::Cast ClothedCast();
// The same with hair.
face::Cast HairyCast();

}  // namespace kaori::tests
