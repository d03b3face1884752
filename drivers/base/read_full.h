// Reading on in an open file, for whoever goes through it once in pieces of his own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "drivers/base/result.h"

namespace kaori {

// Fills `into` from where the descriptor stands; gives how many bytes came, fewer only where the file ended. Signals do not
// cut it short. Blocks for the disk. Errors: those of read(2); `name` is what they say of the file.
Result<std::size_t> ReadFull(int fd, std::span<std::uint8_t> into, const std::string& name);

}  // namespace kaori
