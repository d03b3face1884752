#include "appliance/programs/desk/chance.h"

#include <sys/random.h>

#include <cstdlib>

#include "drivers/base/log.h"

namespace kaori::desk {

void FillByChance(std::span<std::uint8_t> bytes) {
  if (::getrandom(bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size())) return;
  LogError("the kernel gives no random numbers");
  std::abort();
}

}  // namespace kaori::desk
