#include "hw-sim/evening/allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

// Atomic, since threads of any library may allocate. It is never set back.
std::atomic<std::size_t> count{0};

// As ::operator new, but that a machine without memory ends the program: nobody here goes on without.
void* Allocate(std::size_t bytes, std::size_t alignment) {
  ++count;
  // aligned_alloc wants a multiple of the alignment, and 0 bytes must give a pointer of their own.
  const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
  void* const memory = std::aligned_alloc(alignment, whole == 0 ? alignment : whole);
  if (memory == nullptr) std::abort();
  return memory;
}

}  // namespace

std::size_t kaori::sim::AllocationCount() {
  return count;
}

void* operator new(std::size_t bytes) {
  return Allocate(bytes, alignof(std::max_align_t));
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return Allocate(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
