// The headers of a tar archive in POSIX's ustar format (IEEE Std 1003.1, pax), regular files alone: what `tar xf` unpacks.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "drivers/base/result.h"

namespace kaori::backup {

inline constexpr std::size_t kBlock_bytes = 512;
using Block = std::array<std::uint8_t, kBlock_bytes>;

// One file of an archive.
struct Member {
  // 1 to restore::kLongestPath bytes: ustar's prefix is not used.
  std::string path;
  // Below 8 GiB.
  std::uint64_t bytes = 0;
  friend bool operator==(const Member&, const Member&) = default;
};

// The header of a member: mode 0644, nobody's, of no time, so that the same files give the same archive.
Block MakeBlock(const Member& member);

// Reads a header; nothing for a block of zeros, with which an archive ends. Errors: invalid_argument, it is no ustar
// header of a regular file, or its checksum does not fit. Paths are not judged. Pure.
Result<std::optional<Member>> ReadBlock(std::span<const std::uint8_t, kBlock_bytes> block);

// How many zeros follow on a member of this length, up to a whole block.
std::size_t Padding(std::uint64_t bytes);

}  // namespace kaori::backup
