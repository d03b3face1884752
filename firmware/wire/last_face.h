// The file in which a box keeps her last face from one night to the next: a picture of
// it, which the first program shows, and the stage's state, from which it plays on. One
// file, so that they are of one moment. It lies here, below the drivers, because the boot
// splash reads it before anything else of the box runs.
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

// The seal stands at the end, so that a file whose writing was cut short has none.
inline constexpr std::size_t kLastFaceEnd_bytes = 32;
// A picture is 960 pixels wide at most, which makes 1.5 MB at 16 to 9; what is larger was not written by us and is not read.
inline constexpr std::size_t kLargestLastFace_bytes = std::size_t{1} << 21U;
inline constexpr std::array<std::uint8_t, 8> kLastFaceMark{'K', 'A', 'O', 'R', 'I', ' ', 'L', 'F'};
// A show is known by so many bytes at its pack's beginning: its length and its checksum are among them.
inline constexpr std::size_t kShowMark_bytes = 64;

// FNV-1a as in drivers/base/checksum.h, which firmware/ may not include.
inline constexpr std::uint64_t kEmptySum = 0xCBF29CE484222325U;

// FNV-1a, piece by piece: finds a file that was torn. No defence against people.
constexpr std::uint64_t AddSum(std::uint64_t sum, std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) sum = (sum ^ byte) * 0x100000001B3U;
  return sum;
}

// What a file holds, or is to hold. Borrows the file's bytes, which must outlive it.
struct LastFace {
  std::uint64_t show = 0;  // AddSum(kEmptySum, the pack's first kShowMark_bytes).
  // As it lies in the file: a PPM with its head.
  std::span<const std::uint8_t> picture;
  // As it lies in the file: a layout's number, then the bytes.
  std::span<const std::uint8_t> state;
};

// The seal as bytes.
using LastFaceEnd = std::array<std::uint8_t, kLastFaceEnd_bytes>;

// The last 32 bytes of a file that holds this picture and this state. The sum covers the seal's own
// fields before it, so that lengths or a show that were changed are found as well.
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

// None where the file is torn, too large, or something else. The spans of the result
// point into `file`. The picture's own form and the state's layout are for the readers
// to check, and whether the show is the one that plays.
constexpr std::optional<LastFace> ReadLastFace(std::span<const std::uint8_t> file) {
  if (file.size() < kLastFaceEnd_bytes || file.size() > kLargestLastFace_bytes) return std::nullopt;
  const auto body = file.first(file.size() - kLastFaceEnd_bytes);
  // The lengths are compared without a sum of both: two lengths of 32
  // bits each could exceed a size_t of 32 bits.
  const auto end = file.last(kLastFaceEnd_bytes);
  const std::size_t picture = GetU32(end, 16), state = GetU32(end, 20);
  if (picture > body.size() || state != body.size() - picture) return std::nullopt;
  const LastFace face{.show = GetU32(end, 8) | std::uint64_t{GetU32(end, 12)} << 32U,
                      .picture = body.first(picture),
                      .state = body.last(state)};
  // One comparison checks the mark, the show, the lengths and the sum:
  // the seal is made anew and must be the same.
  const LastFaceEnd wanted = EndOf(face);
  if (!std::equal(wanted.begin(), wanted.end(), end.begin())) return std::nullopt;
  return face;
}

}  // namespace kaori::wire
