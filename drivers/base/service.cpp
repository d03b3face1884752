#include "drivers/base/service.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>

#include "drivers/base/number.h"

namespace kaori::service {
namespace {

// Descriptors that the manager passes begin here (SD_LISTEN_FDS_START).
constexpr int kFirstPassed = 3;
// A manager that is busy starting other units answers within a
// second; a hung one must not hang the stage.
constexpr int kServiceLongestWait_ms = 5000;
// A program that is watched may be silent for so long at least.
constexpr Duration kShortestSilence = std::chrono::milliseconds(250);

std::string_view Variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

// What is addressed to another process, as by a parent that forked, is not ours.
bool IsForUs(const char* name) {
  const auto process = ParseNumber<std::int64_t>(Variable(name));
  return !process || *process == ::getpid();
}

// Where the manager listens; a leading '@' stands for the abstract namespace, whose names begin with a
// zero byte and are not terminated: their length counts, as it is passed in msg_namelen.
std::optional<sockaddr_un> ManagerAddress(std::string_view name) {
  sockaddr_un address{};
  if (name.size() < 2 || name.size() >= sizeof(address.sun_path)) return std::nullopt;
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, name.data(), name.size());
  if (name.front() == '@') address.sun_path[0] = 0;
  return address;
}

// Sends `assignments`, with a descriptor where `fd` is one.
Result<void> Send(std::string_view assignments, int fd) {
  const auto name = Variable("NOTIFY_SOCKET");
  auto address = ManagerAddress(name);
  if (!address) return {};
  const UniqueFd socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  iovec text{const_cast<char*>(assignments.data()), assignments.size()};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  msghdr message{};
  message.msg_name = &*address;
  message.msg_namelen = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
  message.msg_iov = &text;
  message.msg_iovlen = 1;
  if (fd >= 0) {
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(header), &fd, sizeof(fd));
  }
  if (::sendmsg(socket.get(), &message, MSG_NOSIGNAL) < 0) return FailErrno("tell the service manager");
  return {};
}

// The manager closes the other end of the pipe when it has read everything before it (BARRIER=1 of
// sd_notify(3)). That end must be closed here first, or the poll would wait for our own copy.
Result<void> AwaitManager() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return FailErrno("make a pipe");
  const UniqueFd ours(ends[0]);
  UniqueFd theirs(ends[1]);
  if (auto sent = Send("BARRIER=1", theirs.get()); !sent) return sent;
  theirs.reset();
  pollfd closed{ours.get(), POLLIN, 0};
  if (::poll(&closed, 1, kServiceLongestWait_ms) != 1)
    return Fail(std::errc::timed_out, "await the service manager");
  return {};
}

// What a manager that watches was told last; 0 before the first beat. There is one manager, and one watchdog.
std::atomic<Duration> g_told{};

Result<void> TellLimit(Duration limit) {
  g_told = limit;
  return Tell(fmt::format("WATCHDOG_USEC={}\nWATCHDOG=1",
                          std::chrono::duration_cast<std::chrono::microseconds>(limit).count()));
}

}  // namespace

Result<void> Tell(std::string_view assignments) {
  return Send(assignments, -1);
}

Result<void> StoreFd(int fd, std::string_view name) {
  if (Variable("NOTIFY_SOCKET").empty()) return {};
  // FDPOLL=0: it is kept even while the device behind it reports a fault.
  if (auto sent = Send(fmt::format("FDSTORE=1\nFDNAME={}\nFDPOLL=0", name), fd); !sent) return sent;
  return AwaitManager();
}

Result<void> ExtendStart(Duration longest) {
  return Tell(fmt::format("EXTEND_TIMEOUT_USEC={}",
                          std::chrono::duration_cast<std::chrono::microseconds>(longest).count()));
}

// As sd_listen_fds_with_names(3) has it: names are in the order of the descriptors, with colons between.
// Close-on-exec is set on the one that is given, which systemd passes without it.
std::optional<UniqueFd> RetrieveFd(std::string_view name) {
  const auto count = ParseNumber<std::int64_t>(Variable("LISTEN_FDS"));
  if (!count || !IsForUs("LISTEN_PID")) return std::nullopt;
  std::string_view names = Variable("LISTEN_FDNAMES");
  for (int i = 0; i < *count; ++i) {
    const auto end = names.find(':');
    if (names.substr(0, end) == name) {
      ::fcntl(kFirstPassed + i, F_SETFD, FD_CLOEXEC);
      return UniqueFd(kFirstPassed + i);
    }
    names = end == std::string_view::npos ? std::string_view() : names.substr(end + 1);
  }
  return std::nullopt;
}

std::optional<Watchdog> Watchdog::Wanted() {
  const auto longest_us = ParseNumber<std::int64_t>(Variable("WATCHDOG_USEC"));
  g_told = Duration();
  if (!longest_us || *longest_us <= 0 || !IsForUs("WATCHDOG_PID")) return std::nullopt;
  return Watchdog(std::chrono::microseconds(*longest_us));
}

Result<void> Watchdog::Beat(Duration turn) {
  const Duration wanted =
      turn <= Duration() ? longest_
                         : std::clamp(turn * kPatientTurns, std::min(kShortestSilence, longest_), longest_);
  // Small changes are not worth a message: only a longer limit, or one that is shorter by a quarter, is
  // sent. A longer one goes out at once, since the old one would kill a machine that became slow.
  if (g_told.load() == limit_ && wanted <= limit_ && wanted * 4 > limit_ * 3) return Tell("WATCHDOG=1");
  return BeatWithin(wanted);
}

Result<void> Watchdog::BeatWithin(Duration limit) {
  limit_ = std::min(limit, longest_);
  return TellLimit(limit_);
}

Result<void> AllowSilence(Duration longest) {
  const Duration told = g_told.load();
  if (told == Duration()) return {};
  // The manager counts from the last message: a limit that was told already begins anew with a beat.
  return longest <= told ? Tell("WATCHDOG=1") : TellLimit(longest);
}

}  // namespace kaori::service
