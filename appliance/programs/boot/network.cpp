#include "appliance/programs/boot/network.h"

#include <arpa/inet.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <netinet/in.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstring>
#include <tuple>
#include <vector>

#include "drivers/base/folder.h"
#include "drivers/base/number.h"
#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"
#include "drivers/base/whole_file.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;

constexpr int kFewestBits = 8, kMostBits = 30;

// The bits of the network are the highest ones.
std::uint32_t MaskOf(int prefix_bits) {
  return ~std::uint32_t{0} << static_cast<unsigned>(32 - prefix_bits);
}

// Four numbers without leading zeros, which some programs take for octal ones.
std::optional<std::uint32_t> ParseAddress(std::string_view text) {
  std::uint32_t address = 0;
  for (int part = 0; part < 4; ++part) {
    const auto end = part < 3 ? text.find('.') : text.size();
    if (end == std::string_view::npos) return std::nullopt;
    const auto digits = text.substr(0, end);
    const auto number = ParseNumber<int>(digits);
    if (!number || *number < 0 || *number > 255 || (digits.size() > 1 && digits.front() == '0'))
      return std::nullopt;
    address = address << 8U | static_cast<std::uint32_t>(*number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return address;
}

// Of the four ranges that no host of a house's network has: 0.*, 127.*, and all from 224.* on.
bool IsForHosts(const NetworkAddress& wanted) {
  const std::uint32_t first = wanted.address >> 24U, host = wanted.address & ~MaskOf(wanted.prefix_bits);
  return first != 0 && first != 127 && first < 224 && host != 0 && host != ~MaskOf(wanted.prefix_bits);
}

// As the kernel's ioctls take it: in the network's order of bytes.
sockaddr_in SocketAddress(std::uint32_t address) {
  sockaddr_in wanted{};
  wanted.sin_family = AF_INET;
  wanted.sin_addr.s_addr = htonl(address);
  return wanted;
}

// USB networks are adapters that somebody plugged in, where a profile lets them be.
bool IsWired(const fs::path& socket) {
  std::error_code none;
  const std::string type = ReadBeginning(socket / "type", 8).value_or("");
  const fs::path bus = fs::canonical(socket / "device/subsystem", none);
  return !none && bus.filename() != "usb" && type == std::to_string(ARPHRD_ETHER) + "\n";
}

// Address before mask, since the kernel makes up a mask for a new address; both before the socket is switched on.
Result<void> GiveAddress(const NetworkAddress& address, const std::string& socket) {
  const UniqueFd fd(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  if (!fd.valid()) return FailErrno("open a socket");
  ifreq request{};
  if (socket.size() >= sizeof request.ifr_name) return Fail(std::errc::filename_too_long, "name " + socket);
  std::memcpy(request.ifr_name, socket.data(), socket.size());
  const auto set = [&](unsigned long what, std::uint32_t number) {
    const sockaddr_in wanted = SocketAddress(number);
    std::memcpy(&request.ifr_addr, &wanted, sizeof wanted);
    return ::ioctl(fd.get(), what, &request) == 0;
  };
  if (!set(SIOCSIFADDR, address.address) || !set(SIOCSIFNETMASK, MaskOf(address.prefix_bits)))
    return FailErrno("give " + socket + " its address");
  if (::ioctl(fd.get(), SIOCGIFFLAGS, &request) < 0) return FailErrno("look at " + socket);
  request.ifr_flags = static_cast<short>(request.ifr_flags | IFF_UP);
  if (::ioctl(fd.get(), SIOCSIFFLAGS, &request) < 0) return FailErrno("switch " + socket + " on");
  return {};
}

}  // namespace

std::string ParseNetwork(std::string_view key, std::string_view value,
                         std::optional<NetworkAddress>& address) {
  if (key != "address") return "there is no setting " + std::string(key) + " of [network]";
  constexpr const char* kExpected = "expected an address with its network's bits, as in \"10.101.90.20/24\"";
  if (value.size() < 2 || value.front() != '"' || value.back() != '"') return kExpected;
  const auto text = value.substr(1, value.size() - 2);
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) return kExpected;
  const auto number = ParseAddress(text.substr(0, slash));
  const auto bits = ParseNumber<int>(text.substr(slash + 1));
  if (!number || !bits) return kExpected;
  if (*bits < kFewestBits || *bits > kMostBits)
    return "the network's bits are 8 to 30, as the 24 in \"10.101.90.20/24\"";
  const NetworkAddress wanted{*number, *bits};
  if (!IsForHosts(wanted)) return std::string(value) + " is no address that a box can have";
  address = wanted;
  return {};
}

// Without inet_ntop(3): process 1 prints its own numbers.
std::string NetworkOf(const NetworkAddress& address) {
  const std::uint32_t network = address.address & MaskOf(address.prefix_bits);
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8)
    text += std::to_string(network >> static_cast<unsigned>(shift) & 255U) + (shift > 0 ? "." : "/");
  return text + std::to_string(address.prefix_bits);
}

// By length and then by letters: eth2 comes before eth10.
Result<std::string> NetworkSocket(const fs::path& classes) {
  std::vector<std::string> sockets;
  for (const fs::path& socket : ListFolder(classes).value_or(std::vector<fs::path>()))
    if (IsWired(socket)) sockets.push_back(socket.filename().string());
  const auto first = std::ranges::min_element(
      sockets, {}, [](const std::string& name) { return std::make_tuple(name.size(), name); });
  if (first == sockets.end())
    return Fail(std::errc::no_such_device, "find a network card that the kernel drives");
  return *first;
}

// The sandbox of all programs denies every address (kaori-.service.d/sandbox.conf); what is allowed here counts before that.
Result<void> LimitDesk(const NetworkAddress& address, const fs::path& units) {
  const fs::path folder = units / "kaori-desk.service.d";
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) return Fail(static_cast<std::errc>(failed.value()), "make " + folder.string());
  const std::string limits = "[Service]\nIPAddressAllow=" + NetworkOf(address) + "\n";
  return WriteWholeFile(folder / "network.conf", {AsBytes(limits)});
}

// The limit first: no address is there for a desk that would talk to everybody.
Result<void> JoinNetwork(const NetworkAddress& address, const fs::path& classes, const fs::path& units) {
  const auto socket = NetworkSocket(classes);
  if (!socket) return tl::unexpected(socket.error());
  if (auto ok = LimitDesk(address, units); !ok) return ok;
  return GiveAddress(address, *socket);
}

}  // namespace kaori::boot
