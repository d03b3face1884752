#include "drivers/hid/local_bus.h"

#include <sys/epoll.h>
#include <sys/inotify.h>

#include <array>
#include <cstring>
#include <filesystem>

#include "drivers/base/folder.h"
#include "drivers/base/packet_socket.h"
#include "drivers/hid/local_channel.h"
#include "firmware/wire/link.h"

namespace kaori::hid {
namespace {

namespace fs = std::filesystem;

// Sockets of HID devices in the folder are named "hid." and the port.
constexpr std::string_view kPrefix = "hid.";
// A socket that does not listen yet (packet_socket.h).
constexpr std::string_view kUnfinished = ".new";
// Sockets appear by renaming and go by unlinking; the last two tell that the folder itself went.
constexpr std::uint32_t kChanges =
    IN_MOVED_TO | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_DELETE_SELF | IN_MOVE_SELF;

// The port that a file of the folder stands for; empty if none.
std::string PortOf(std::string_view file) {
  if (!file.starts_with(kPrefix) || file.ends_with(kUnfinished)) return {};
  return std::string(file.substr(kPrefix.size()));
}

// The device's queue of connections is full: it is there, but cannot answer now.
bool IsBusy(const Error& error) {
  return error.cause == std::errc::resource_unavailable_try_again;
}

// Adds a descriptor to the bus's epoll set.
Result<void> Join(int epoll, int fd) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = fd;
  if (::epoll_ctl(epoll, EPOLL_CTL_ADD, fd, &event) < 0) return FailErrno("watch the local link");
  return {};
}

}  // namespace

Result<std::unique_ptr<ports::HidBus>> LocalHidBus::Watch(const std::string& folder) {
  UniqueFd epoll(::epoll_create1(EPOLL_CLOEXEC));
  if (!epoll.valid()) return FailErrno("create the local link's epoll set");
  std::unique_ptr<LocalHidBus> bus(new LocalHidBus(folder, std::move(epoll)));
  if (auto watched = bus->WatchFolder(); !watched) return tl::unexpected(watched.error());
  return bus;
}

std::string LocalHidBus::PathOf(const std::string& port) const {
  return folder_ + "/" + std::string(kPrefix) + port;
}

// Watches first and lists then: what is plugged in between is seen twice, never missed.
Result<void> LocalHidBus::WatchFolder() {
  watching_ = false;
  connections_.clear();
  std::error_code error;
  fs::create_directories(folder_, error);
  UniqueFd watch(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
  if (!watch.valid()) return FailErrno("create a watch for " + folder_);
  if (::inotify_add_watch(watch.get(), folder_.c_str(), kChanges | IN_ONLYDIR) < 0)
    return FailErrno("watch the link folder " + folder_);
  if (auto joined = Join(epoll_.get(), watch.get()); !joined) return joined;
  watch_ = std::move(watch);
  watching_ = true;
  for (const fs::path& path : ListFolder(folder_).value_or(std::vector<fs::path>{}))
    Refresh(PortOf(path.filename().string()));
  return {};
}

Result<std::vector<std::string>> LocalHidBus::Ports() {
  if (auto drained = DrainNotices(); !drained) return tl::unexpected(drained.error());
  std::vector<std::string> ports;
  for (auto& [port, connection] : connections_) {
    if (connection.state == State::kConnecting) ReceiveHello(port, connection);
    if (connection.state != State::kConnecting && connection.state != State::kRefused) ports.push_back(port);
  }
  return ports;
}

Result<void> LocalHidBus::DrainNotices() {
  alignas(inotify_event) std::array<char, 4096> buffer;
  bool folder_gone = !watching_;
  // Notices have variable lengths, and are copied out: the buffer need not be aligned for each.
  for (ssize_t bytes = 0; (bytes = ::read(watch_.get(), buffer.data(), buffer.size())) > 0;) {
    for (std::size_t at = 0; at < static_cast<std::size_t>(bytes);) {
      inotify_event event;
      std::memcpy(&event, buffer.data() + at, sizeof(event));
      // IN_Q_OVERFLOW: notices were lost, so everything is looked at anew, as if the folder were new.
      folder_gone |= (event.mask & (IN_DELETE_SELF | IN_MOVE_SELF | IN_IGNORED | IN_Q_OVERFLOW)) != 0;
      if (event.len > 0) Refresh(PortOf(buffer.data() + at + sizeof(event)));
      at += sizeof(event) + event.len;
    }
  }
  return folder_gone ? WatchFolder() : Result<void>{};
}

// Something happened at a port: connects again, since it may be another device's now.
void LocalHidBus::Refresh(const std::string& port) {
  if (port.empty()) return;
  connections_.erase(port);
  std::error_code error;
  if (fs::is_socket(PathOf(port), error)) Connect(port);
}

// A socket that is there and whose owner has no room for callers now is busy, and tried again by Open; any
// other failure is final until the folder says something new of it.
void LocalHidBus::Connect(const std::string& port) {
  Connection connection;
  auto socket = ConnectToPeer(PathOf(port));
  if (socket && Join(epoll_.get(), socket->get()))
    connection.socket = std::move(*socket);
  else
    connection.state = !socket && IsBusy(socket.error()) ? State::kBusy : State::kRefused;
  connections_.insert_or_assign(port, std::move(connection));
}

void LocalHidBus::ReceiveHello(const std::string& port, Connection& connection) {
  std::array<std::uint8_t, wire::kMaxLinkPacket> buffer;
  // The hello is the first packet of a connection; nothing else is read here.
  const auto packet = ReceivePacket(connection.socket.get(), buffer);
  if (!packet && IsBusy(packet.error())) return;
  auto identity = packet ? ReadHello(port, std::span(buffer).first(packet->bytes)) : std::nullopt;
  // Its reports are for the channel: from here on they must not make the bus readable.
  ::epoll_ctl(epoll_.get(), EPOLL_CTL_DEL, connection.socket.get(), nullptr);
  connection.state = identity ? State::kReady : State::kRefused;
  if (identity)
    connection.identity = std::move(*identity);
  else
    connection.socket.reset();
}

Result<std::unique_ptr<ports::HidChannel>> LocalHidBus::Open(const std::string& port) {
  const auto found = connections_.find(port);
  if (found == connections_.end()) return Fail(std::errc::no_such_device, "open port " + port);
  Connection& connection = found->second;
  if (connection.state == State::kOpened || connection.state == State::kBusy) Connect(port);
  if (connection.state == State::kConnecting) ReceiveHello(port, connection);
  if (connection.state == State::kRefused) return Fail(std::errc::no_such_device, "open port " + port);
  if (connection.state == State::kConnecting || connection.state == State::kBusy)
    return Fail(std::errc::device_or_resource_busy, "open port " + port + ": it has not answered yet");
  connection.state = State::kOpened;
  return std::make_unique<LocalHidChannel>(std::move(connection.socket), connection.identity);
}

}  // namespace kaori::hid
