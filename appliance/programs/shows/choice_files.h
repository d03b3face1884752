// The choice among the shows, as whoever installs reads and writes it in the folder of shows.
#pragma once

#include "appliance/core/store/choice.h"
#include "appliance/programs/shows/folder.h"
#include "drivers/base/result.h"

namespace kaori::shows {

// What WriteChoice writes first. It is no id and no choice, so that no reader of the folder ever takes it for
// one.
inline constexpr const char* kNewChoice = "choice.new";

// Writes a choice, in the file that its generation says, and returns once it is on the disk: the choice is
// then this one, whatever happens. Errors: those of the folder; then the choice before still stands.
Result<void> WriteChoice(Folder& folder, const store::Choice& choice);

// The choice as the folder has it, and whether it has one (store::HasChoice).
store::Choice ReadChoice(const Folder& folder);
bool HasChoice(const Folder& folder);

}  // namespace kaori::shows
