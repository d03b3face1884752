// FNV-1a with 64 bits: finds a torn record or a spoilt file, and tells sets of names apart. It is no defence
// against people.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace kaori {

// The offset basis and the prime of 64 bits (http://www.isthe.com/chongo/tech/comp/fnv/).
inline constexpr std::uint64_t kFnvBasis = 0xCBF29CE484222325U;
inline constexpr std::uint64_t kFnvPrime = 0x100000001B3U;

// The sum of `bytes`. The sum of several pieces is made one after the other: `sum` is that of the pieces before.
constexpr std::uint64_t Fnv1a(std::span<const std::uint8_t> bytes, std::uint64_t sum = kFnvBasis) {
  for (const std::uint8_t byte : bytes) sum = (sum ^ byte) * kFnvPrime;
  return sum;
}

constexpr std::uint64_t Fnv1a(std::string_view text, std::uint64_t sum = kFnvBasis) {
  for (const char letter : text) sum = (sum ^ static_cast<unsigned char>(letter)) * kFnvPrime;
  return sum;
}

}  // namespace kaori
