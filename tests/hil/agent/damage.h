// Damages the image of a file system, the same for the same number on every machine. Pure.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace kaori::agent {

// Changes 1 to 16 places of `image`: bits turned over, bytes, runs of 00 or FF, sectors of 512 bytes that are
// exchanged or copied, or everything behind a place lost. Three of four places lie in the first
// `described_bytes`, where boot sector, tables and folders lie. `number` chooses what and where. Nothing is
// changed where the image is empty. Errors: none.
void Damage(std::span<std::uint8_t> image, std::size_t described_bytes, std::uint64_t number);

}  // namespace kaori::agent
