// The cue sheet: what whoever calls a show reads on paper.
#pragma once

#include <string>

#include "appliance/core/show/show.h"

namespace kaori::authoring {

enum class SheetLanguage { kEnglish, kJapanese };

// One HTML file that needs nothing beside it and is laid out for A4 paper: the cues by act, each with its
// number, what begins it, what happens with its times in seconds, its notes, and room for a pencil. The
// list's own words (names, acts, notes) stand as the show has them; everything else is in `language`. A show
// without cues has its scenes as cues, as it is played. Texts of the show are escaped. `show` is tracked
// (show::Track), as LoadPack returns it.
std::string CueSheet(const show::Show& show, SheetLanguage language);

}  // namespace kaori::authoring
