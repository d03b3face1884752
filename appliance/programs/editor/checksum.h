// FNV-1a, 64 bits: finds a record that was torn, and tells one set of names from another. No defence against
// people.
#pragma once

#include <cstdint>
#include <span>

namespace kaori::editor {

constexpr std::uint64_t Checksum(std::span<const std::uint8_t> bytes) {
  std::uint64_t sum = 0xCBF29CE484222325U;
  for (const std::uint8_t byte : bytes) sum = (sum ^ byte) * 0x100000001B3U;
  return sum;
}

}  // namespace kaori::editor
