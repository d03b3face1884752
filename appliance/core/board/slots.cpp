#include "appliance/core/board/slots.h"

namespace kaori::board {
namespace {

// A slot is overwritten every fourth write; to lose this often a writer must be quicker than a copy, for
// long. A copy of the largest section (8 KB) takes microseconds, and no writer publishes more than 1000 times
// a second.
constexpr int kTries = 64;
// Words of a section's head.
constexpr std::size_t kNewest = 0;
constexpr std::size_t kPid = 1;

template <class W>
W* SlotOf(W* section, std::uint32_t generation, std::size_t value_words) {
  return section + kSectionHeadWords + (generation % kSlots) * SlotWords(value_words);
}

// In front of a slot's value: its generation, or that nothing whole lies there.
constexpr std::uint32_t kNothing = 0;

// The next generation. 0 means that a slot is empty, so after the last generation comes kSlots, a new first
// one that lies in the same slot as 0 would: consecutive values never share a slot. Right after the wrap,
// once in 2^32 writes, older values read as missing until three more are written.
std::uint32_t After(std::uint32_t generation) {
  return generation + 1 == kNothing ? kSlots : generation + 1;
}

// Boehm, "Can seqlocks get along with programming language memory models?" (2012): the value's loads acquire,
// so the second look at the generation comes after them; where one of them saw a word of a later write, it
// also sees that write's kNothing or a later generation, and the copy is thrown away.
bool FetchSlot(const Word* slot, std::uint32_t generation, std::span<std::uint32_t> value) {
  if (generation == kNothing || slot[0].load(std::memory_order_acquire) != generation) return false;
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = slot[1 + i].load(std::memory_order_acquire);
  return slot[0].load(std::memory_order_relaxed) == generation;
}

}  // namespace

// The order matters: the slot is emptied before its first word changes, gets its generation after its last,
// and the head names it at the very end. Each value word is stored with release, so that none can be seen
// before the emptying.
void Publish(Word* section, std::span<const std::uint32_t> value) {
  const std::uint32_t generation = After(section[kNewest].load(std::memory_order_relaxed));
  Word* slot = SlotOf(section, generation, value.size());
  slot[0].store(kNothing, std::memory_order_relaxed);
  for (std::size_t i = 0; i < value.size(); ++i) slot[1 + i].store(value[i], std::memory_order_release);
  slot[0].store(generation, std::memory_order_release);
  section[kNewest].store(generation, std::memory_order_release);
}

// The head is read anew in each try: an age counts from what is newest at that moment.
bool Fetch(const Word* section, std::uint32_t age, std::span<std::uint32_t> value) {
  for (int i = 0; i < kTries; ++i) {
    const std::uint32_t newest = section[kNewest].load(std::memory_order_acquire);
    if (FetchSlot(SlotOf(section, newest - age, value.size()), newest - age, value)) return true;
  }
  return false;
}

std::uint32_t WriterPid(const Word* section) {
  return section[kPid].load(std::memory_order_relaxed);
}

void SetWriterPid(Word* section, std::uint32_t pid) {
  section[kPid].store(pid, std::memory_order_relaxed);
}

}  // namespace kaori::board
