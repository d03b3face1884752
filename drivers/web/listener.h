// Opens the socket on which a web server listens.
#pragma once

#include <cstdint>
#include <string>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::web {

// Who can connect: programs of this machine, or everybody who reaches it.
enum class Reach : std::uint8_t {
  kThisMachine,  // 127.0.0.1.
  kNetwork,      // Every address of the machine.
};

// A listening, non-blocking TCP socket on IPv4; `port` 0 is any free one. `address` is one of this
// machine's own ("192.168.0.7", "0.0.0.0" for all); empty: as `reach` says. A port that a program has
// just left can be used at once (SO_REUSEADDR). Errors:
//   address_in_use         another program listens on the port
//   permission_denied      the port is below 1024
//   invalid_argument       `address` is no IPv4 address
//   address_not_available  `address` is not of this machine
Result<UniqueFd> ListenForVisitors(std::uint16_t port, Reach reach, const std::string& address = {});

}  // namespace kaori::web
