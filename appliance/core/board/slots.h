// A section's sequence lock: one writer, any number of readers, none of whom ever waits for another.
//
// A section is an array of 32-bit atomic words: the newest generation, the writer's process id, then kSlots
// slots of a generation word and a value each. Generation g lies in slot g % kSlots, so the writer never
// touches the newest value, and dying in the middle of a write spoils nothing that readers look at. A reader
// takes the very generation that it looked for and no later one, so that what it sees never goes back.
//
// Words are stored with release and loaded with acquire order instead of fences: whoever saw one new word
// sees that the slot was emptied before it. On x86 both are plain moves, and ThreadSanitizer can follow them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kaori::board {

using Word = std::atomic<std::uint32_t>;
// An atomic that locks would lock in one process only, and the file's layout counts on its size.
static_assert(Word::is_always_lock_free && sizeof(Word) == sizeof(std::uint32_t));

// The number of slots is a power of two, so that generations find their slot over the wrap of 32 bits as
// well. With four a reader is disturbed only when three more values were written while it copied one.
inline constexpr std::uint32_t kSlots = 4;
inline constexpr std::size_t kSectionHeadWords = 16;  // A cache line of its own.

// Words of a slot (its generation word and a value) and of a whole section. Slots are padded to 64 bytes, so
// that the writer's slot and the one that is read share no cache line.
constexpr std::size_t SlotWords(std::size_t value_words) {
  return (1 + value_words + 15) / 16 * 16;
}
constexpr std::size_t SectionWords(std::size_t value_words) {
  return kSectionHeadWords + kSlots * SlotWords(value_words);
}

// Publishes `value` as the newest. One writer at a time (the caller's lock sees to it); never waits. A
// section has one length of value for its whole life, that of `value`. A writer that dies in between leaves a
// slot that says kNothing and the newest generation as it was.
void Publish(Word* section, std::span<const std::uint32_t> value);

// Copies the value `age` generations before the newest (0 is the newest) into `value`. False: there is none,
// its writer died over it, or it was overwritten faster than it could be read, several times in a row. `age`
// is below kSlots. `value` holds anything after false. Lock-free, but not wait-free in theory: it gives up
// after a bounded number of tries.
bool Fetch(const Word* section, std::uint32_t age, std::span<std::uint32_t> value);

// The process id that the section's writer left; 0: none ever wrote.
std::uint32_t WriterPid(const Word* section);
// Leaves the caller's process id, for the message that a second writer gets. Called once, with the section
// locked.
void SetWriterPid(Word* section, std::uint32_t pid);

}  // namespace kaori::board
