// Whoever looks at a trial may hang or end, too, and is started again: what it then knows of the look before.
#pragma once

#include <filesystem>

#include "appliance/programs/update/reason.h"

namespace kaori::update {

// Why a system gives way that nobody could judge.
Reason VainLook();

// A system that is tried begins to be looked at. `file` is in memory: it is gone with this start of the machine. One that
// cannot be written is one line in the log, and a look that hangs begins anew then.
void BeginLook(const std::filesystem::path& file);

// It was no trial after all: whoever looks next finds none in vain.
void EndLook(const std::filesystem::path& file);

// How many looks of this start came to no verdict, as whoever looks next asks once, before it touches a disk; each time
// that it asks counts as one more. 0 where none has begun: this start is no trial, or it is not known yet. After one the
// system is to give way; after two it is to do so without a word, since it hung as it said so.
int LooksInVain(const std::filesystem::path& file);

}  // namespace kaori::update
