#include "hw-sim/console/guard.h"

#include <string_view>

namespace kaori::console {
namespace {

// "127.0.0.1:8080" names this machine; "127.0.0.1.example.org" does not.
bool IsLoopback(std::string_view host) {
  const auto colon = host.find(':');
  if (colon != std::string_view::npos && host.find_first_not_of("0123456789", colon + 1) != host.npos)
    return false;
  const auto name = host.substr(0, colon);
  return name == "127.0.0.1" || name == "localhost";
}

bool IsSameOrigin(std::string_view origin, std::string_view host) {
  constexpr std::string_view kScheme = "http://";
  return origin.starts_with(kScheme) && origin.substr(kScheme.size()) == host;
}

}  // namespace

std::optional<std::string> Refusal(const web::Visitor& visitor) {
  if (!IsLoopback(visitor.host)) return "the console answers only to 127.0.0.1 and localhost";
  if (!visitor.origin.empty() && !IsSameOrigin(visitor.origin, visitor.host))
    return "the console takes no hands from pages of other sites";
  const auto site = visitor.fetch_site;
  if (!site.empty() && site != "same-origin" && site != "none")
    return "the console cannot be embedded by other sites";
  return std::nullopt;
}

}  // namespace kaori::console
