// Bytes that nobody can foresee.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

namespace kaori::desk {

// Fills all of it.
using Chance = std::function<void(std::span<std::uint8_t>)>;

// The kernel's; ends the program where there are none, for a code that can be guessed is worse.
void FillByChance(std::span<std::uint8_t> bytes);

}  // namespace kaori::desk
