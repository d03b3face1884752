// Whose requests are looked at: pages that the desk served itself, under an address of the box.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/web/http_server.h"

namespace kaori::desk {

struct GateRules {
  std::vector<std::string> names;  // Under which the box is known, besides numbers.
  bool secure = true;              // HTTPS.
};

// Why the request is refused, in one line, or nothing. A page of another site that had its name resolved to
// the box shows in Host, for that is a name and none of the box's; one that sends requests, or holds our
// pictures, shows in Origin or Sec-Fetch-Site. A request that changes anything has an Origin.
std::optional<std::string> Refusal(const web::Visitor& visitor, const GateRules& rules);

// The names of this machine: its host name, that with .local, and localhost.
std::vector<std::string> OwnNames();

// Its first address on a network, 0xC0A80001 for 192.168.0.1; 127.0.0.1 where there is none.
std::uint32_t OwnAddress();

}  // namespace kaori::desk
