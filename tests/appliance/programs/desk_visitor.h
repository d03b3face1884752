// A visitor over a real socket: it sends and receives bytes as slowly and as wrongly as a test needs.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "drivers/base/unique_fd.h"

namespace kaori::tests {

class Visitor {
 public:
  // Connects to 127.0.0.1, from 127.0.0.`host`. `pump` runs the other side.
  Visitor(std::uint16_t port, std::function<void()> pump, std::uint32_t host = 1)
      : fd_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)), pump_(std::move(pump)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl((INADDR_LOOPBACK & ~0xFFU) | host);
    static_cast<void>(::bind(fd_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)));
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = ::connect(fd_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  }

  bool connected() const { return connected_; }
  int fd() const { return fd_.get(); }

  // False when the other side has hung up.
  bool Send(std::string_view bytes) {
    return ::send(fd_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT) >= 0;
  }

  // All that comes until `enough` says so, the other side hangs up, or it has been silent for a second.
  std::string Receive(const std::function<bool(const std::string&)>& enough) {
    std::string all;
    for (int silent = 0; silent < 1000 && !enough(all);) {
      pump_();
      pollfd wait{fd_.get(), POLLIN, 0};
      if (::poll(&wait, 1, 1) == 0) {
        ++silent;
        continue;
      }
      std::array<char, 65536> bytes;
      const ssize_t got = ::recv(fd_.get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
      if (got <= 0) return all;
      all.append(bytes.data(), static_cast<std::size_t>(got));
      silent = 0;
    }
    return all;
  }

  // The other side has hung up, or does so within a second.
  bool IsCutOff() {
    for (int turn = 0; turn < 1000; ++turn) {
      pump_();
      pollfd wait{fd_.get(), POLLIN, 0};
      if (::poll(&wait, 1, 1) == 0) continue;
      std::array<char, 65536> bytes;
      const ssize_t got = ::recv(fd_.get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
      if (got == 0 || (got < 0 && errno != EAGAIN)) return true;
    }
    return false;
  }

 private:
  UniqueFd fd_;
  std::function<void()> pump_;
  bool connected_ = false;
};

// So many visitors who say nothing, or, each second one, only this beginning.
inline std::vector<std::unique_ptr<Visitor>> CrowdOf(int count, std::uint16_t port,
                                                     const std::function<void()>& pump,
                                                     std::string_view beginning) {
  std::vector<std::unique_ptr<Visitor>> crowd;
  for (int n = 0; n < count; ++n) {
    crowd.push_back(std::make_unique<Visitor>(port, pump));
    if (n % 2 == 1) crowd.back()->Send(beginning);
  }
  return crowd;
}

// As many descriptors as this process may have: a crowd has its ends in it, and those of the other side.
inline void AllowManyDescriptors() {
  rlimit descriptors{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &descriptors), 0);
  descriptors.rlim_cur = descriptors.rlim_max;
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &descriptors), 0);
}

// A reply of one piece has come whole.
inline bool IsWhole(const std::string& reply) {
  const auto end = reply.find("\r\n\r\n");
  if (end == std::string::npos) return false;
  const auto at = reply.find("Content-Length: ");
  if (at == std::string::npos || at > end) return true;
  return reply.size() >= end + 4 + std::stoul(reply.substr(at + 16));
}

inline int StatusOf(const std::string& reply) {
  return reply.size() > 12 ? std::stoi(reply.substr(9, 3)) : 0;
}

struct Asked {
  std::string method = "GET";
  std::string path = "/";
  std::string body{};
  std::string cookie{};
  std::string host{};  // As the page's address has it, if not given; likewise the origin.
  std::string origin{};
  std::string more{};  // Further header lines.
};

inline std::string RequestOf(const Asked& asked, std::uint16_t port) {
  const std::string host = asked.host.empty() ? fmt::format("127.0.0.1:{}", port) : asked.host;
  std::string text = fmt::format("{} {} HTTP/1.1\r\nHost: {}\r\n", asked.method, asked.path, host);
  if (!asked.cookie.empty()) text += "Cookie: " + asked.cookie + "\r\n";
  const std::string origin = !asked.origin.empty()    ? asked.origin
                             : asked.method == "POST" ? "http://" + host
                                                      : "";
  if (!origin.empty() && origin != "none") text += "Origin: " + origin + "\r\n";
  if (asked.method == "POST") text += fmt::format("Content-Length: {}\r\n", asked.body.size());
  return text + asked.more + "\r\n" + asked.body;
}

// So many visitors of 127.0.0.`host` who ask for a part of the page again and again and receive nothing.
inline std::vector<std::unique_ptr<Visitor>> DeafCrowdOf(int count, std::uint16_t port,
                                                         const std::function<void()>& pump,
                                                         std::uint32_t host) {
  constexpr int kAsks = 400;
  std::string asks;
  for (int n = 0; n < kAsks; ++n) asks += RequestOf({.path = "/texts.js"}, port);
  std::vector<std::unique_ptr<Visitor>> crowd;
  for (int n = 0; n < count; ++n) {
    crowd.push_back(std::make_unique<Visitor>(port, pump, host));
    crowd.back()->Send(asks);
  }
  return crowd;
}

}  // namespace kaori::tests
