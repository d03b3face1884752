// A jaw has an end to its way: what is played on top of an expression takes it no further.
#pragma once

#include "render/face/cast.h"
#include "render/face/weights.h"

namespace kaori::face {

// As far as an expression has the jaw open, of the widest there is (by the drop of point "LC" on the
// reference face), the channels that drop it open it no second time; and as far as they open it, the
// expression's own mouth yields to them, by half at most. Changes channels and mouth_given_away. Indices must
// be those of the cast (Playable). Leaves a cast without that point alone. Pure; allocates nothing.
void LimitJaw(const Cast& cast, Weights& weights);

}  // namespace kaori::face
