// Where teeth and tongue lie in the texture.
#pragma once

#include "appliance/authoring/import/heads.h"

namespace kaori::import {

// Teeth and tongue are pieces of their own, for which tools like to unwrap the whole square once more.
//
// How much of the area that teeth and tongue have in the texture lies over the skin's: 0..1; 0 where there are none.
float MouthOverSkin(const Heads& heads);

// Moves teeth and tongue into a strip above the skin, which is drawn a little lower for it, so that what is painted for the one
// is not seen on the other. For heads whose skin is painted here: an artist's own picture would no longer fit. The skin must
// lie within 0..1.
void PutMouthBesideSkin(Heads& heads);

}  // namespace kaori::import
