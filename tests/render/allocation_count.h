// Counts what the program under test allocates on the heap.
#pragma once

#include <cstddef>

namespace kaori::tests {

// Calls of operator new, of any form, on any thread, since the program started.
std::size_t AllocationCount();

}  // namespace kaori::tests
