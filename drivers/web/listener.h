// A socket that waits for visitors.
#pragma once

#include <cstdint>
#include <string>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::web {

enum class Reach : std::uint8_t {
  kThisMachine,  // 127.0.0.1.
  kNetwork,      // Every address of the machine.
};

// IPv4, TCP; `port` 0 is any free one. `address` is one of this machine's own ("192.168.0.7", "0.0.0.0" for all); empty: as
// `reach` says. Errors: address_in_use, permission_denied (a port below 1024), invalid_argument (no IPv4 address),
// address_not_available (not of this machine).
Result<UniqueFd> ListenForVisitors(std::uint16_t port, Reach reach, const std::string& address = {});

}  // namespace kaori::web
