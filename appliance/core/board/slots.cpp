#include "appliance/core/board/slots.h"

namespace kaori::board {
namespace {

// A slot is overwritten every fourth write; to lose this often a writer must be quicker than a copy, for
// long.
constexpr int kTries = 64;
constexpr std::size_t kNewest = 0;
constexpr std::size_t kPid = 1;

template <class W>
W* SlotOf(W* section, std::uint32_t generation, std::size_t value_words) {
  return section + kSectionHeadWords + (generation % kSlots) * SlotWords(value_words);
}

// In front of a slot's value: its generation, or that nothing whole lies there.
constexpr std::uint32_t kNothing = 0;

// After the last generation comes a new first one, which lies in the same slot as 0 would.
std::uint32_t After(std::uint32_t generation) {
  return generation + 1 == kNothing ? kSlots : generation + 1;
}

bool FetchSlot(const Word* slot, std::uint32_t generation, std::span<std::uint32_t> value) {
  if (generation == kNothing || slot[0].load(std::memory_order_acquire) != generation) return false;
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = slot[1 + i].load(std::memory_order_acquire);
  return slot[0].load(std::memory_order_relaxed) == generation;
}

}  // namespace

void Publish(Word* section, std::span<const std::uint32_t> value) {
  const std::uint32_t generation = After(section[kNewest].load(std::memory_order_relaxed));
  Word* slot = SlotOf(section, generation, value.size());
  slot[0].store(kNothing, std::memory_order_relaxed);
  for (std::size_t i = 0; i < value.size(); ++i) slot[1 + i].store(value[i], std::memory_order_release);
  slot[0].store(generation, std::memory_order_release);
  section[kNewest].store(generation, std::memory_order_release);
}

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
