// The box's address in a network: none, unless its settings name one. IPv4, one address that never changes, on one socket.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/base/result.h"

namespace kaori::boot {

// "10.101.90.20/24": the box's own address, and how many bits of it are the network's.
struct NetworkAddress {
  // The first of its four numbers in the highest eight bits.
  std::uint32_t address = 0;
  // 8 to 30.
  int prefix_bits = 0;
  friend bool operator==(const NetworkAddress&, const NetworkAddress&) = default;
};

// Takes one setting of the section [network]: address = "10.101.90.20/24". Says what is wrong with it, or nothing; `address`
// changes only where all is right. Refused is what no host can have: the network's own address, that of all hosts in it, and
// those of loopback, multicast and the reserved ranges (RFC 6890). Pure.
std::string ParseNetwork(std::string_view key, std::string_view value,
                         std::optional<NetworkAddress>& address);

// The network with its prefix, "10.101.90.0/24", as systemd wants it. Pure.
std::string NetworkOf(const NetworkAddress& address);

// The Ethernet socket that gets the address, as "eth0": the first that is no USB device, in the order of their numbers, where
// `classes` is /sys/class/net. Errors: no_such_device, there is none.
Result<std::string> NetworkSocket(const std::filesystem::path& classes);

// Lets the desk talk to its own network and to nobody else: a drop-in of its unit in `units`, where systemd looks for those that
// last until the next start. Errors: those of WriteWholeFile.
Result<void> LimitDesk(const NetworkAddress& address, const std::filesystem::path& units);

// Gives the socket the address, switches it on, and limits the desk, before systemd runs. Needs CAP_NET_ADMIN. Waits for no cable.
// Errors: those of NetworkSocket and LimitDesk, of socket(2) and of the kernel's ioctls (netdevice(7));
// address_family_not_supported: a kernel without IPv4.
Result<void> JoinNetwork(const NetworkAddress& address, const std::filesystem::path& classes,
                         const std::filesystem::path& units);

}  // namespace kaori::boot
