// The verbs about packs, each in a file of its own: verb_NAME.cpp.
#pragma once

#include "appliance/authoring/pack/verb.h"

namespace kaori::authoring {

Verb CheckVerb();
Verb DiffVerb();
Verb InfoVerb();
Verb KeygenVerb();
Verb LabelsVerb();
Verb PackVerb();
Verb SheetVerb();

}  // namespace kaori::authoring
