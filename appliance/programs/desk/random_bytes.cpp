#include "appliance/programs/desk/random_bytes.h"

#include <sys/random.h>

#include <cstdlib>

#include "drivers/base/log.h"

namespace kaori::desk {

// Flags of 0: /dev/urandom, but not before it was seeded.
void FillWithKernelRandom(std::span<std::uint8_t> bytes) {
  if (::getrandom(bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size())) return;
  LogError("getrandom failed; the desk ends, since its codes could be guessed");
  std::abort();
}

}  // namespace kaori::desk
