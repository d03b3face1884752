// The file in which a box keeps her last face from one night to the next: a picture of it, which the first
// program shows, and the stage's state, from which it plays on. One file, so that they are of one moment.
//
//   the picture      a PPM: "P6\n", width, height, 255, then red, green, blue
//   the state        as board::Performance has it: its layout (u32, little-endian), then its bytes
//   the end          32 bytes: "KAORI LF", the show (u64), bytes of picture and state (u32 each), and FNV-1a
//                    (64 bits) of all that stands before it
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/wire/bytes.h"

namespace kaori::wire {

inline constexpr std::size_t kLastFaceEnd_bytes = 32;
inline constexpr std::size_t kLargestLastFace_bytes = std::size_t{1} << 21U;
inline constexpr std::array<std::uint8_t, 8> kLastFaceMark{'K', 'A', 'O', 'R', 'I', ' ', 'L', 'F'};
// A show is known by so many bytes at its pack's beginning: its length and its checksum are among them.
inline constexpr std::size_t kShowMark_bytes = 64;

inline constexpr std::uint64_t kEmptySum = 0xCBF29CE484222325U;

// FNV-1a, piece by piece: finds a file that was torn. No defence against people.
constexpr std::uint64_t AddSum(std::uint64_t sum, std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) sum = (sum ^ byte) * 0x100000001B3U;
  return sum;
}

// Borrows the file's bytes.
struct LastFace {
  std::uint64_t show = 0;  // AddSum(kEmptySum, the pack's first kShowMark_bytes).
  std::span<const std::uint8_t> picture;
  std::span<const std::uint8_t> state;
};

using LastFaceEnd = std::array<std::uint8_t, kLastFaceEnd_bytes>;

constexpr LastFaceEnd EndOf(const LastFace& face) {
  LastFaceEnd end{};
  std::copy(kLastFaceMark.begin(), kLastFaceMark.end(), end.begin());
  PutU32(end, 8, static_cast<std::uint32_t>(face.show));
  PutU32(end, 12, static_cast<std::uint32_t>(face.show >> 32U));
  PutU32(end, 16, static_cast<std::uint32_t>(face.picture.size()));
  PutU32(end, 20, static_cast<std::uint32_t>(face.state.size()));
  std::uint64_t sum = AddSum(AddSum(kEmptySum, face.picture), face.state);
  sum = AddSum(sum, std::span(end).first(24));
  PutU32(end, 24, static_cast<std::uint32_t>(sum));
  PutU32(end, 28, static_cast<std::uint32_t>(sum >> 32U));
  return end;
}

// None where the file is torn, too large, or something else.
constexpr std::optional<LastFace> ReadLastFace(std::span<const std::uint8_t> file) {
  if (file.size() < kLastFaceEnd_bytes || file.size() > kLargestLastFace_bytes) return std::nullopt;
  const auto body = file.first(file.size() - kLastFaceEnd_bytes);
  const auto end = file.last(kLastFaceEnd_bytes);
  const std::size_t picture = GetU32(end, 16), state = GetU32(end, 20);
  if (picture > body.size() || state != body.size() - picture) return std::nullopt;
  const LastFace face{.show = GetU32(end, 8) | std::uint64_t{GetU32(end, 12)} << 32U,
                      .picture = body.first(picture),
                      .state = body.last(state)};
  const LastFaceEnd wanted = EndOf(face);
  if (!std::equal(wanted.begin(), wanted.end(), end.begin())) return std::nullopt;
  return face;
}

}  // namespace kaori::wire
