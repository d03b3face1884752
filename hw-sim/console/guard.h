// Who may use the console: pages that it served itself, on this machine.
#pragma once

#include <optional>
#include <string>

#include "drivers/web/http_server.h"

namespace kaori::console {

// Why the request is refused, in one line, or nothing. A page of another site that had its name resolved to
// this machine shows in Host; one that sends us requests or embeds our picture shows in Origin or
// Sec-Fetch-Site.
std::optional<std::string> Refusal(const web::Visitor& visitor);

}  // namespace kaori::console
