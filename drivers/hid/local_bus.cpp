#include "drivers/hid/local_bus.h"

#include <sys/epoll.h>
#include <sys/inotify.h>

#include <array>
#include <cstring>
#include <filesystem>

#include "drivers/base/packet_socket.h"
#include "drivers/hid/local_channel.h"
#include "firmware/wire/link.h"

namespace kaori::hid {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "hid.";
constexpr std::string_view kUnfinished = ".new";  // A socket that does not listen yet.
constexpr std::uint32_t kChanges =
    IN_MOVED_TO | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_DELETE_SELF | IN_MOVE_SELF;

// The port that a file of the folder stands for; empty if none.
std::string PortOf(std::string_view file) {
  if (!file.starts_with(kPrefix) || file.ends_with(kUnfinished)) return {};
  return std::string(file.substr(kPrefix.size()));
}

bool IsBusy(const Error& error) {
  return error.cause == std::errc::resource_unavailable_try_again;
}

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
  lines_.clear();
  std::error_code error;
  fs::create_directories(folder_, error);
  UniqueFd watch(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
  if (!watch.valid()) return FailErrno("create a watch for " + folder_);
  if (::inotify_add_watch(watch.get(), folder_.c_str(), kChanges | IN_ONLYDIR) < 0)
    return FailErrno("watch the link folder " + folder_);
  if (auto joined = Join(epoll_.get(), watch.get()); !joined) return joined;
  watch_ = std::move(watch);
  watching_ = true;
  for (const auto& entry : fs::directory_iterator(folder_, error))
    LookAt(PortOf(entry.path().filename().string()));
  return {};
}

Result<std::vector<std::string>> LocalHidBus::Ports() {
  if (auto taken = DrainNotices(); !taken) return tl::unexpected(taken.error());
  std::vector<std::string> ports;
  for (auto& [port, line] : lines_) {
    if (line.state == State::kCalling) Answer(port, line);
    if (line.state != State::kCalling && line.state != State::kRefused) ports.push_back(port);
  }
  return ports;
}

Result<void> LocalHidBus::DrainNotices() {
  alignas(inotify_event) std::array<char, 4096> buffer;
  bool folder_gone = !watching_;
  for (ssize_t bytes = 0; (bytes = ::read(watch_.get(), buffer.data(), buffer.size())) > 0;) {
    for (std::size_t at = 0; at < static_cast<std::size_t>(bytes);) {
      inotify_event event;
      std::memcpy(&event, buffer.data() + at, sizeof(event));
      folder_gone |= (event.mask & (IN_DELETE_SELF | IN_MOVE_SELF | IN_IGNORED | IN_Q_OVERFLOW)) != 0;
      if (event.len > 0) LookAt(PortOf(buffer.data() + at + sizeof(event)));
      at += sizeof(event) + event.len;
    }
  }
  return folder_gone ? WatchFolder() : Result<void>{};
}

// Something happened at a port: what was known of it counts no more. (The same inode number may be another
// device's, so it is called again.)
void LocalHidBus::LookAt(const std::string& port) {
  if (port.empty()) return;
  lines_.erase(port);
  std::error_code error;
  if (fs::is_socket(PathOf(port), error)) Call(port);
}

void LocalHidBus::Call(const std::string& port) {
  Line line;
  auto socket = ConnectToPeer(PathOf(port));
  if (socket && Join(epoll_.get(), socket->get()))
    line.socket = std::move(*socket);
  else
    line.state = !socket && IsBusy(socket.error()) ? State::kBusy : State::kRefused;
  lines_.insert_or_assign(port, std::move(line));
}

void LocalHidBus::Answer(const std::string& port, Line& line) {
  std::array<std::uint8_t, wire::kMaxLinkPacket> buffer;
  const auto packet = ReceivePacket(line.socket.get(), buffer);
  if (!packet && IsBusy(packet.error())) return;
  auto identity = packet ? ReadHello(port, std::span(buffer).first(packet->bytes)) : std::nullopt;
  // Its reports are for the channel: from here on they do not wake the bus.
  ::epoll_ctl(epoll_.get(), EPOLL_CTL_DEL, line.socket.get(), nullptr);
  line.state = identity ? State::kGreeted : State::kRefused;
  if (identity)
    line.identity = std::move(*identity);
  else
    line.socket.reset();
}

Result<std::unique_ptr<ports::HidChannel>> LocalHidBus::Open(const std::string& port) {
  const auto found = lines_.find(port);
  if (found == lines_.end()) return Fail(std::errc::no_such_device, "open port " + port);
  Line& line = found->second;
  if (line.state == State::kOpened || line.state == State::kBusy) Call(port);
  if (line.state == State::kCalling) Answer(port, line);
  if (line.state == State::kRefused) return Fail(std::errc::no_such_device, "open port " + port);
  if (line.state == State::kCalling || line.state == State::kBusy)
    return Fail(std::errc::device_or_resource_busy, "open port " + port + ": it has not answered yet");
  line.state = State::kOpened;
  return std::make_unique<LocalHidChannel>(std::move(line.socket), line.identity);
}

}  // namespace kaori::hid
