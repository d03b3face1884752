// A few bytes that stay: the ends of a stick's axes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "firmware/surface/flash.h"

namespace kaori::surface {

// Two sectors with a copy each. What is stored goes over the older one, so that a cut at any moment leaves
// the old bytes or the new ones.
//
//   0 u32 "KST1", 4 u32 generation, 8 u16 length, 10 the bytes, then u8[4] the beginning of the SHA-256 of all before
inline constexpr std::size_t kMostStoredBytes = 128;

// What was stored last; nothing: nothing was, or both copies are damaged. Good until the next Erase or
// Program.
std::optional<std::span<const std::uint8_t>> Load(const Flash& flash);
// More than kMostStoredBytes are cut. Does nothing where the same bytes are there already.
void Store(Flash& flash, std::span<const std::uint8_t> bytes);

}  // namespace kaori::surface
