// Which requests are answered: those of pages that the desk served itself, under an address of the box.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/web/http_server.h"

namespace kaori::desk {

// What the box is called, and how it is served: what a request of our own page must look like.
struct OriginRules {
  std::vector<std::string> names;  // The host names of the box, besides its numeric addresses.
  bool secure = true;              // HTTPS.
};

// Returns why a request is refused, in one line, or nothing. A site whose name was made to resolve to the box
// (DNS rebinding) has its own name in Host. A page of another site that sends requests, or embeds the desk's
// pictures, is recognised by Origin or Sec-Fetch-Site. A request that changes anything must have an Origin.
// Pure. It stands before pairing: a refused request is answered with nothing but the reason.
std::optional<std::string> Refusal(const web::Visitor& visitor, const OriginRules& rules);

// The names of this machine: its host name, that with .local, and localhost. ".local" is how mDNS names it.
// In small letters; asked of the kernel.
std::vector<std::string> OwnNames();

// This machine's first IPv4 address on a network, 0xC0A80001 for 192.168.0.1; 127.0.0.1 where there is none.
std::uint32_t OwnAddress();

}  // namespace kaori::desk
