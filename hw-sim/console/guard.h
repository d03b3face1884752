// Who may use the console: pages that it served itself, on this machine.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace kaori::console {

// Headers of a request; empty where the request has none.
struct Visitor {
  std::string_view host{};
  std::string_view origin{};
  std::string_view fetch_site{};  // Sec-Fetch-Site.
};

// Why the request is refused, in one line, or nothing. A page of another site that had its name resolved to
// this machine shows in Host; one that sends us requests or embeds our picture shows in Origin or
// Sec-Fetch-Site.
std::optional<std::string> Refusal(const Visitor& visitor);

}  // namespace kaori::console
