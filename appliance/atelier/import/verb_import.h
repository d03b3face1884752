// kaori-atelier import.
#pragma once

#include "appliance/atelier/pack/verb.h"

namespace kaori::atelier {

Verb ImportVerb();

}  // namespace kaori::atelier
