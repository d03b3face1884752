#include "appliance/programs/desk/origin_check.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <memory>

namespace kaori::desk {
namespace {

// The host in small letters without its port, such as ":8443"; empty where what follows the colon is no port.
// Colons within the brackets of an IPv6 address are none of a port.
std::string NameIn(std::string_view host) {
  const auto bracket = host.find(']');
  const auto colon = host.find(':', bracket == std::string_view::npos ? 0 : bracket);
  if (colon != std::string_view::npos && host.find_first_not_of("0123456789", colon + 1) != host.npos)
    return {};
  std::string name(host.substr(0, colon));
  std::ranges::transform(name, name.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return name;
}

// An address in digits cannot be rebound: only names are looked up in DNS.
bool IsNumbers(const std::string& name) {
  in_addr four{};
  in6_addr six{};
  if (::inet_pton(AF_INET, name.c_str(), &four) == 1) return true;
  return name.size() > 2 && name.front() == '[' && name.back() == ']' &&
         ::inet_pton(AF_INET6, name.substr(1, name.size() - 2).c_str(), &six) == 1;
}

bool IsOurs(std::string_view host, const OriginRules& rules) {
  const std::string name = NameIn(host);
  return !name.empty() && (IsNumbers(name) || std::ranges::find(rules.names, name) != rules.names.end());
}

// Scheme, host and port all equal (RFC 6454).
bool IsSameOrigin(std::string_view origin, std::string_view host, bool secure) {
  const std::string_view scheme = secure ? "https://" : "http://";
  return origin.starts_with(scheme) && origin.substr(scheme.size()) == host;
}

}  // namespace

// A browser leaves Origin out of plain reads of its own page, so that an empty one is good for reads only.
// Sec-Fetch-Site, where it is sent, settles the rest: "none" is an address that a person typed.
std::optional<std::string> Refusal(const web::Visitor& visitor, const OriginRules& rules) {
  if (!IsOurs(visitor.host, rules)) return "the request names a host that is not an address of the box";
  const bool reads = visitor.method == "GET" || visitor.method == "HEAD";
  if (visitor.origin.empty() ? !reads : !IsSameOrigin(visitor.origin, visitor.host, rules.secure))
    return "the request comes from a page of another site";
  const auto site = visitor.fetch_site;
  if (!site.empty() && site != "same-origin" && site != "none")
    return "the request comes from a page of another site";
  return std::nullopt;
}

// A machine that cannot name itself still has localhost.
std::vector<std::string> OwnNames() {
  std::vector<std::string> names{"localhost"};
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0 || host[0] == '\0') return names;
  const std::string name = NameIn(host.data());
  names.push_back(name);
  names.push_back(name + ".local");
  return names;
}

// The first interface that is up and not the loopback, in the kernel's order. A box with several networks
// shows one of its addresses; the others work as well.
std::uint32_t OwnAddress() {
  ifaddrs* all = nullptr;
  if (::getifaddrs(&all) != 0) return INADDR_LOOPBACK;
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> owned(all, ::freeifaddrs);
  for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET) continue;
    if ((one->ifa_flags & IFF_LOOPBACK) != 0 || (one->ifa_flags & IFF_UP) == 0) continue;
    return ntohl(reinterpret_cast<const sockaddr_in*>(one->ifa_addr)->sin_addr.s_addr);
  }
  return INADDR_LOOPBACK;
}

}  // namespace kaori::desk
