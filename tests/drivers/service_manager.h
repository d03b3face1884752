// A service manager that hears what a program tells it.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "drivers/base/service.h"
#include "drivers/base/unique_fd.h"

namespace kaori::tests {

// The manager's end of the notification socket, in the abstract namespace so that no file is left.
class Manager {
 public:
  Manager() : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    EXPECT_EQ(::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address.sun_family)),
              0);
    socklen_t length = sizeof(address);
    ::getsockname(socket_.get(), reinterpret_cast<sockaddr*>(&address), &length);
    name_ = "@" + std::string(address.sun_path + 1, length - offsetof(sockaddr_un, sun_path) - 1);
    ::setenv("NOTIFY_SOCKET", name_.c_str(), 1);
  }
  ~Manager() { ::unsetenv("NOTIFY_SOCKET"); }

  // What it was told since the last call, without waiting.
  std::vector<std::string> Heard() {
    std::vector<std::string> heard;
    for (pollfd waiting{socket_.get(), POLLIN, 0}; ::poll(&waiting, 1, 0) > 0;) heard.push_back(Read().words);
    return heard;
  }

  struct Message {
    std::string words;
    UniqueFd descriptor;
  };
  Message Read() {
    std::array<char, 256> text{};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
    iovec into{text.data(), text.size()};
    msghdr message{};
    message.msg_iov = &into;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    const ssize_t bytes = ::recvmsg(socket_.get(), &message, MSG_CMSG_CLOEXEC);
    Message read{std::string(text.data(), bytes > 0 ? std::size_t(bytes) : 0), {}};
    if (const cmsghdr* header = CMSG_FIRSTHDR(&message)) {
      int fd = -1;
      std::memcpy(&fd, CMSG_DATA(header), sizeof(fd));
      read.descriptor = UniqueFd(fd);
    }
    return read;
  }

 private:
  UniqueFd socket_;
  std::string name_;
};

// What the program tells before a call that may block, once its watchdog has begun.
inline constexpr const char* kPatience = "WATCHDOG_USEC=12000000\nWATCHDOG=1";

// A manager that watches this program; its patience is short, as after a beat.
class WatchingManager {
 public:
  WatchingManager() {
    ::setenv("WATCHDOG_USEC", "10000000", 1);
    Beat();
  }
  ~WatchingManager() {
    ::unsetenv("WATCHDOG_USEC");
    service::Watchdog::Wanted();  // There is none from here on.
  }
  // What it was told until now.
  std::vector<std::string> Beat() {
    auto heard = manager_.Heard();
    EXPECT_TRUE(service::Watchdog::Wanted().value().Beat(std::chrono::milliseconds(20)));
    manager_.Heard();
    return heard;
  }

 private:
  Manager manager_;
};

}  // namespace kaori::tests
