// The verb that makes a show of heads from modelling tools.
#pragma once

#include "appliance/authoring/pack/verb.h"

namespace kaori::authoring {

Verb ImportVerb();

}  // namespace kaori::authoring
