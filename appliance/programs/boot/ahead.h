// Reads ahead what the stage will touch, so that its blocks are fetched and verified while the system starts.
#pragma once

#include <cstddef>

namespace kaori::boot {

// Brings every piece of a file that `list` names, in its order, into the kernel's memory. A line is a path,
// which means the whole file, or "FIRST BYTES PATH": how many bytes from which one on, in decimal digits.
// What is not there is passed over, and so is a piece with which it would be more than `most_bytes`. Blocks
// for the disk: for a process of its own. No more than one piece of a file is asked of the disk at a time, so
// that what other programs read does not wait behind a large file. Returns how many bytes were asked for.
// Nothing fails: what cannot be read is read later, by whoever needs it.
std::size_t ReadAhead(const char* list, std::size_t most_bytes);

}  // namespace kaori::boot
