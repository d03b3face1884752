// What grows far out of a head, and where it goes while faces that differ in it are mixed: back into the
// head.
#pragma once

#include <vector>

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/faces.h"
#include "appliance/authoring/sculpt/recipe.h"
#include "render/face/cast.h"

namespace kaori::sculpt {

// Fills Topology::outgrowth with the ears' blocks and the neck, and for each face how they are withdrawn, to
// a low bump on the ear's own rim and to a dome that closes the head under the jaw, and of which kind they
// are: a turned body has a handle in place of ears, and no neck; and how what hangs of an animal swings. A cast of one
// kind in which nothing hangs gets nothing. `shaped` and `recipe` are those of cast.faces, in its order; pure.
void AddOutgrowths(const Cage& cage, const std::vector<ShapedFace>& shaped, const CastRecipe& recipe,
                   face::Cast& cast);

}  // namespace kaori::sculpt
