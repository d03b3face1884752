// Random bytes for codes and session names.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

namespace kaori::desk {

// Fills the whole span with random bytes.
using RandomBytes = std::function<void(std::span<std::uint8_t>)>;

// Fills `bytes` from getrandom(2). It ends the program where that fails, since a code that can be guessed is
// worse. Blocks only until the kernel has gathered entropy once after its start. At most 256 bytes at once,
// which getrandom never gives in part. Any thread.
void FillWithKernelRandom(std::span<std::uint8_t> bytes);

}  // namespace kaori::desk
