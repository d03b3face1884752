#include "drivers/scanout/hotplug_monitor.h"

#include <linux/netlink.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>

namespace kaori::scanout {
namespace {

constexpr unsigned kKernelGroup = 1;  // Multicast group of the kernel itself; udev sends its own to group 2.

}  // namespace

bool IsScreenHotplug(std::span<const char> uevent) {
  // Both fields are needed: other changes of a card are reported as well.
  bool of_graphics = false;
  bool of_plugs = false;
  for (auto rest = uevent; !rest.empty();) {
    const auto end = std::ranges::find(rest, '\0');
    const std::string_view field(rest.begin(), end);
    of_graphics = of_graphics || field == "SUBSYSTEM=drm";
    of_plugs = of_plugs || field == "HOTPLUG=1";
    rest = rest.subspan(std::min(field.size() + 1, rest.size()));
  }
  return of_graphics && of_plugs;
}

Result<HotplugMonitor> HotplugMonitor::Open() {
  UniqueFd socket(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_KOBJECT_UEVENT));
  if (!socket.valid()) return FailErrno("listen for uevents of screens");
  sockaddr_nl address{};
  address.nl_family = AF_NETLINK;
  address.nl_groups = kKernelGroup;
  if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
    return FailErrno("listen for uevents of screens");
  return HotplugMonitor(std::move(socket));
}

bool HotplugMonitor::Drain() {
  bool heard = false;
  while (socket_.valid()) {
    // A uevent has 2 KiB at most (UEVENT_BUFFER_SIZE in the kernel).
    std::array<char, 4096> bytes;
    sockaddr_nl sender{};
    socklen_t length = sizeof(sender);
    const ssize_t got = ::recvfrom(socket_.get(), bytes.data(), bytes.size(), 0,
                                   reinterpret_cast<sockaddr*>(&sender), &length);
    // ENOBUFS: uevents were lost, and one of them may have reported a screen.
    if (got < 0 && errno == ENOBUFS) heard = true;
    // Nothing is left, or the socket failed: then nothing is heard any more.
    if (got < 0 && errno != ENOBUFS && errno != EINTR) break;
    // Only the kernel has the port id 0: other processes may send to the socket too.
    if (got > 0 && sender.nl_pid == 0 && IsScreenHotplug(std::span(bytes).first(std::size_t(got))))
      heard = true;
  }
  return heard;
}

}  // namespace kaori::scanout
