// FNV-1a with 64 bits: finds a torn record or a spoilt file, and tells sets of
// names apart. It is no defence against people, who can make two inputs of one sum
// with little work; packs are signed for that reason.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace kaori {

// The offset basis and the prime of 64 bits (http://www.isthe.com/chongo/tech/comp/fnv/).
inline constexpr std::uint64_t kFnvBasis = 0xCBF29CE484222325U;
inline constexpr std::uint64_t kFnvPrime = 0x100000001B3U;

// The sum of `bytes`. The sum of several pieces is made one after the other: `sum` is that of the pieces
// before, so that a file need not lie in memory as a whole. For each byte: exclusive or first, then the
// product modulo 2^64 (that order is the "a" of FNV-1a). A caller stores it little-endian.
constexpr std::uint64_t Fnv1a(std::span<const std::uint8_t> bytes, std::uint64_t sum = kFnvBasis) {
  for (const std::uint8_t byte : bytes) sum = (sum ^ byte) * kFnvPrime;
  return sum;
}

// The same over the bytes of a text; its end is not marked, so "ab"
// with "c" gives the sum of "a" with "bc".
constexpr std::uint64_t Fnv1a(std::string_view text, std::uint64_t sum = kFnvBasis) {
  for (const char letter : text) sum = (sum ^ static_cast<unsigned char>(letter)) * kFnvPrime;
  return sum;
}

}  // namespace kaori
