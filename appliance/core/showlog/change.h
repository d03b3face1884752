// What changed between two arrays of words, in few bytes.
//
// Words are taken in groups of eight. A group in which something changed is one byte that says how many
// groups before it did not (1: none; 255: 254 of them, and the count goes on in the next byte), one byte with
// a bit for each word that changed, two bits for each of these that say how many bytes follow for it (1 to 4;
// four words share a byte), and these bytes: the difference modulo 2^32, with its sign in the lowest bit,
// little-endian. 0 in place of a count ends the list. Counters, stamps and floats that move a little differ
// in their low bytes alone, so that most words take one to three.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kaori::showlog {

// The most bytes that a change of so many words can take: groups of 8 words with a count, a mask, 2 bytes of
// lengths and 32 of differences, the counts that run over, and the end.
constexpr std::size_t MostChange_bytes(std::size_t words) {
  const std::size_t groups = (words + 7) / 8;
  return groups * 36 + groups / 254 + 1;
}

// Writes what changed from `before` to `now`, which are equally long, and gives the bytes used. `into` has
// MostChange_bytes of them. Allocates nothing.
std::size_t WriteChange(std::span<const std::uint32_t> before, std::span<const std::uint32_t> now,
                        std::span<std::uint8_t> into);

// Applies what WriteChange wrote to `words`, which hold what was before, and gives the bytes read. Nothing
// where the bytes end too early or name words beyond the last; `words` may be half changed then.
std::optional<std::size_t> ReadChange(std::span<const std::uint8_t> from, std::span<std::uint32_t> words);

}  // namespace kaori::showlog
