// Who may use the console: pages that it served itself.
#pragma once

#include <optional>
#include <string>

#include "drivers/web/http_server.h"

namespace kaori::console {

// The guard of a console that listens on `address` (empty: on 127.0.0.1). It says why a request is refused,
// in one line, or nothing.
//
// A page of another site that had its name resolved to this machine (DNS rebinding) shows in Host: there only
// the names of this machine are right. On a network these are the IPv4 addresses as numbers, which no name
// service has a part in, and the machine's own host name, alone or with ".local". A page of another site that
// sends us requests or embeds our picture shows in Origin or Sec-Fetch-Site.
web::Guard GuardFor(const std::string& address);

// The host of the page's address: `address`, 127.0.0.1 where that is empty, this machine's name where it is
// 0.0.0.0.
std::string HostFor(const std::string& address);

}  // namespace kaori::console
