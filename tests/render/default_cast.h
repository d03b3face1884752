// The default show's cast: five faces and all expressions as the sculptor makes them, without paint and hair.
#pragma once

#include "render/face/cast.h"

namespace kaori::tests {

// Sculpted once in a test program, in a fraction of a second. Fails the program with the sculptor's message if
// the show's files have a fault.
const face::Cast& DefaultCast();

}  // namespace kaori::tests
