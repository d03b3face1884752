#include "hw-sim/console/guard.h"

#include <arpa/inet.h>
#include <unistd.h>

#include <array>
#include <string_view>

namespace kaori::console {
namespace {

constexpr const char* kEverywhere = "0.0.0.0";

// Empty where the machine has no name; then only numbers are right.
std::string MachineName() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : std::string();
}

// The name before the port; nothing where what stands there is no port. Host is
// "name" or "name:port" (RFC 9110, 7.2).
std::optional<std::string> NameIn(std::string_view host) {
  const auto colon = host.find(':');
  if (colon != std::string_view::npos && host.find_first_not_of("0123456789", colon + 1) != host.npos)
    return std::nullopt;
  return std::string(host.substr(0, colon));
}

// "127.0.0.1:8080" names this machine; "127.0.0.1.example.org" does not.
bool IsLoopback(const std::string& name) {
  return name == "127.0.0.1" || name == "localhost";
}

bool IsAddress(const std::string& name) {
  in_addr parsed{};
  return ::inet_pton(AF_INET, name.c_str(), &parsed) == 1;
}

// Names and addresses are compared as they are written: browsers write host names in lower case.
bool NamesThisMachine(std::string_view host, bool on_network) {
  const auto name = NameIn(host);
  if (!name) return false;
  if (IsLoopback(*name)) return true;
  if (!on_network) return false;
  const std::string machine = MachineName();
  return IsAddress(*name) || (!machine.empty() && (*name == machine || *name == machine + ".local"));
}

// Browsers send Origin as "scheme://host:port", without a path. The console speaks plain HTTP.
bool IsSameOrigin(std::string_view origin, std::string_view host) {
  constexpr std::string_view kScheme = "http://";
  return origin.starts_with(kScheme) && origin.substr(kScheme.size()) == host;
}

// Why a request is refused; the order is from what says most to what says least.
std::optional<std::string> Refusal(const web::Visitor& visitor, bool on_network) {
  if (!NamesThisMachine(visitor.host, on_network))
    return on_network ? "the console answers only to this machine's address and name"
                      : "the console answers only to 127.0.0.1 and localhost";
  if (!visitor.origin.empty() && !IsSameOrigin(visitor.origin, visitor.host))
    return "the console accepts no input from pages of other sites";
  // "none" is what people type into the address bar; curl and old browsers send no such header at all.
  const auto site = visitor.fetch_site;
  if (!site.empty() && site != "same-origin" && site != "none")
    return "the console cannot be embedded by other sites";
  return std::nullopt;
}

}  // namespace

web::Guard GuardFor(const std::string& address) {
  const bool on_network = !address.empty() && !IsLoopback(address);
  return [on_network](const web::Visitor& visitor) { return Refusal(visitor, on_network); };
}

std::string HostFor(const std::string& address) {
  if (address.empty()) return "127.0.0.1";
  if (address != kEverywhere) return address;
  const std::string name = MachineName();
  return name.empty() ? address : name;
}

}  // namespace kaori::console
