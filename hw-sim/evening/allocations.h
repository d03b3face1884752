// Counts what this program allocates on the heap, so that an evening can say that its frames allocated
// nothing.
#pragma once

#include <cstddef>

namespace kaori::sim {

// Calls of operator new, of any form, by the thread that asks, since it began. C's malloc, which Mesa uses,
// is not counted.
std::size_t AllocationsOfThread();

}  // namespace kaori::sim
