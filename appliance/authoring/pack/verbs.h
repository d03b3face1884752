// The verbs about packs, each in a file of its own: verb_NAME.cpp.
#pragma once

#include "appliance/authoring/pack/verb.h"

namespace kaori::authoring {

// Every fault of a folder.
Verb CheckVerb();
// The cue list on paper.
Verb CueSheetVerb();
// What changed between two packs.
Verb DiffVerb();
// What a pack holds.
Verb InfoVerb();
// A key pair that signs packs.
Verb KeygenVerb();
// Pictures for keys with screens.
Verb KeysVerb();
// The labels of the operators' controls.
Verb LabelsVerb();
// From a folder to a pack.
Verb PackVerb();
// What happened on an evening.
Verb ReportVerb();
// A signature on a pack that is there.
Verb SignVerb();
// Contact sheets.
Verb SheetVerb();
// A motion of what operators did.
Verb VerbOfTakes();

}  // namespace kaori::authoring
