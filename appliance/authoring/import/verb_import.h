// The verb that makes a show of heads from modelling tools.
#pragma once

#include "appliance/authoring/pack/verb.h"

namespace kaori::authoring {

// "kaori-atelier import FILE... --out ...": exits 0, or prints the faults and exits with the
// status of ExitWithError.
Verb ImportVerb();

}  // namespace kaori::authoring
