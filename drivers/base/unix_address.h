// A path as the kernel wants it for a Unix socket.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>

#include <cstring>
#include <optional>
#include <string>

namespace kaori {

// An address in the file system. Nothing: the path is too long (sun_path holds 107 bytes and the zero
// behind them). The whole struct may be passed as the length: a path ends at its first zero.
inline std::optional<sockaddr_un> UnixAddress(const std::string& path) {
  sockaddr_un address{};
  if (path.size() >= sizeof(address.sun_path)) return std::nullopt;
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.data(), path.size());
  return address;
}

}  // namespace kaori
