// The cue list of a show, as tables of a pack.
#pragma once

#include "appliance/core/show/pack_copier.h"

namespace kaori::show {

// The list as a table in `to`, which owns it. Cues that Track made of the scenes are left out: whoever reads the pack
// makes them again, so that a pack has one truth of each cue. Never fails.
flatbuffers::Offset<pack::CueList> WriteCueList(flatbuffers::FlatBufferBuilder& to, const CueList& list);

// A list that is absent reads as one without cues. What does not fit reads as what CheckShow refuses. Does
// not Track.
CueList ReadCueList(Copier& from, const pack::CueList* stored);

}  // namespace kaori::show
