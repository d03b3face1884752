// The verb that makes a show of heads from modelling tools.
#pragma once

#include "appliance/atelier/pack/verb.h"

namespace kaori::atelier {

Verb ImportVerb();

}  // namespace kaori::atelier
