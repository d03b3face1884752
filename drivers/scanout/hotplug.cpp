#include "drivers/scanout/hotplug.h"

#include <linux/netlink.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>

namespace kaori::scanout {
namespace {

constexpr unsigned kKernelsOwn = 1;  // The group of uevents that come from the kernel itself.

}  // namespace

// Strings, each with a zero behind it: "change@/devices/...", then "NAME=value".
bool SpeaksOfScreens(std::span<const char> uevent) {
  bool of_graphics = false;
  bool of_plugs = false;
  for (auto rest = uevent; !rest.empty();) {
    const auto end = std::ranges::find(rest, '\0');
    const std::string_view word(rest.begin(), end);
    of_graphics = of_graphics || word == "SUBSYSTEM=drm";
    of_plugs = of_plugs || word == "HOTPLUG=1";
    rest = rest.subspan(std::min(word.size() + 1, rest.size()));
  }
  return of_graphics && of_plugs;
}

Result<Hotplug> Hotplug::Open() {
  UniqueFd socket(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_KOBJECT_UEVENT));
  if (!socket.valid()) return FailErrno("listen for screens that come and go");
  sockaddr_nl address{};
  address.nl_family = AF_NETLINK;
  address.nl_groups = kKernelsOwn;
  if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
    return FailErrno("listen for screens that come and go");
  return Hotplug(std::move(socket));
}

bool Hotplug::Heard() {
  bool heard = false;
  while (socket_.valid()) {
    std::array<char, 4096> bytes;
    sockaddr_nl sender{};
    socklen_t length = sizeof(sender);
    const ssize_t got = ::recvfrom(socket_.get(), bytes.data(), bytes.size(), 0,
                                   reinterpret_cast<sockaddr*>(&sender), &length);
    // Too much came at once, and something was lost: it may have been of screens.
    if (got < 0 && errno == ENOBUFS) heard = true;
    if (got < 0 && errno != ENOBUFS && errno != EINTR) break;
    if (got > 0 && sender.nl_pid == 0 && SpeaksOfScreens(std::span(bytes).first(std::size_t(got))))
      heard = true;
  }
  return heard;
}

}  // namespace kaori::scanout
