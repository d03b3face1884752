// Counts what a program allocates on the heap, so that a test or an evening can say that its frames allocate
// nothing. Linked into a program, it takes the place of operator new and delete there.
#pragma once

#include <cstddef>

namespace kaori::sim {

// Calls of operator new, of any form, on any thread, since the program started. C's malloc, which Mesa uses,
// is not counted.
std::size_t AllocationCount();

}  // namespace kaori::sim
