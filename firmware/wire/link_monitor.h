// The operators' monitor of the local link: a file in the link folder that the stage draws into.
//
// Whoever shows the monitor makes the file "monitor.picture" with the size that it wants, and removes it when it is
// done: the stage draws its monitor only where it is there. It is written and read as a whole, by pwrite(2) and
// pread(2): a file that somebody cuts short harms neither end. All numbers are little-endian:
//     0  u32 'KMON'   4  u32 width   8  u32 height   12  u32 count
//    16  width * height times R, G, B, X, the bottom row first
// The count is 0 before the first picture, odd while one is written, and another even number after each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/wire/bytes.h"

namespace kaori::wire {

inline constexpr char kMonitorFile[] = "/monitor.picture";  // Behind the folder's path.
inline constexpr std::size_t kMonitorHeader_bytes = 16, kMonitorCountAt = 12;
inline constexpr std::uint32_t kMonitorMark = 0x4E4F4D4B;  // 'KMON', little-endian.
inline constexpr std::uint32_t kMonitorMost_px = 4096;     // Of either side.

struct MonitorHeader {
  std::uint32_t width_px = 0;
  std::uint32_t height_px = 0;
  std::uint32_t count = 0;

  constexpr std::size_t picture_bytes() const { return std::size_t{width_px} * height_px * 4; }
};

constexpr std::array<std::uint8_t, kMonitorHeader_bytes> Encode(const MonitorHeader& header) {
  std::array<std::uint8_t, kMonitorHeader_bytes> bytes{};
  PutU32(bytes, 0, kMonitorMark);
  PutU32(bytes, 4, header.width_px);
  PutU32(bytes, 8, header.height_px);
  PutU32(bytes, kMonitorCountAt, header.count);
  return bytes;
}

// Nothing for other bytes, and for a size that no monitor has.
constexpr std::optional<MonitorHeader> DecodeMonitorHeader(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kMonitorHeader_bytes || GetU32(bytes, 0) != kMonitorMark) return std::nullopt;
  const MonitorHeader header{GetU32(bytes, 4), GetU32(bytes, 8), GetU32(bytes, kMonitorCountAt)};
  const auto is_side = [](std::uint32_t side_px) { return side_px > 0 && side_px <= kMonitorMost_px; };
  return is_side(header.width_px) && is_side(header.height_px) ? std::optional(header) : std::nullopt;
}

}  // namespace kaori::wire
