// A jaw has an end to its way: what is played on top of an expression takes it no further.
#pragma once

#include "render/face/cast.h"
#include "render/face/weights.h"

namespace kaori::face {

// As far as an expression has the jaw open, of the widest there is (by the drop of point "LC"), the channels
// that drop it open it no second time; and as far as they open it, the expression's own mouth yields to them.
// Leaves a cast without that point alone.
void LimitJaw(const Cast& cast, Weights& weights);

}  // namespace kaori::face
