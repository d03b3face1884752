// A rehearsal of a show that nobody sees: whether it plays at all, found out before it is anybody's show.
#pragma once

#include "appliance/core/show/show.h"
#include "drivers/base/result.h"

namespace kaori::stage {

// Draws the first frame of each scene, small and without a screen. Blocks for as long as shaders and frames
// take. Errors: those of Studio::Open and Studio::Draw, which name the scene; invalid_argument where the
// first frames of all scenes are one colour: nobody is seen in any of them.
Result<void> Rehearse(show::Show show);

}  // namespace kaori::stage
