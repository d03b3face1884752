#include "appliance/board/slots.h"

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

// An even sequence marks a whole value, an odd one a value being written, 0 a slot never used.
bool FetchSlot(const Word* slot, std::span<std::uint32_t> value) {
  const std::uint32_t before = slot[0].load(std::memory_order_acquire);
  if (before == 0 || before % 2 != 0) return false;
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = slot[1 + i].load(std::memory_order_acquire);
  return slot[0].load(std::memory_order_relaxed) == before;
}

}  // namespace

void Publish(Word* section, std::span<const std::uint32_t> value) {
  const std::uint32_t generation = section[kNewest].load(std::memory_order_relaxed) + 1;
  Word* slot = SlotOf(section, generation, value.size());
  // An odd sequence found here is a dead writer's: the next odd one takes the slot over.
  const std::uint32_t writing = (slot[0].load(std::memory_order_relaxed) + 1) | 1U;
  slot[0].store(writing, std::memory_order_relaxed);
  for (std::size_t i = 0; i < value.size(); ++i) slot[1 + i].store(value[i], std::memory_order_release);
  const std::uint32_t whole = writing + 1 == 0 ? 2 : writing + 1;
  slot[0].store(whole, std::memory_order_release);
  section[kNewest].store(generation, std::memory_order_release);
}

bool Fetch(const Word* section, std::uint32_t age, std::span<std::uint32_t> value) {
  for (int i = 0; i < kTries; ++i) {
    const std::uint32_t newest = section[kNewest].load(std::memory_order_acquire);
    if (FetchSlot(SlotOf(section, newest - age, value.size()), value)) return true;
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
