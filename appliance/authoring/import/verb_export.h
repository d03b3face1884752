// The verb that gives a face of a show to modelling tools.
#pragma once

#include "appliance/authoring/pack/verb.h"

namespace kaori::authoring {

// "kaori-atelier export SHOW FILE --face ...": exits 0, or prints why not and exits with the status of
// ExitWithError.
Verb ExportVerb();

}  // namespace kaori::authoring
