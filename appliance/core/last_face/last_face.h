// The file in which a box keeps its last face from one night to the next: a picture of it, which kaori-boot
// shows, and the stage's state, from which kaori-stage plays on. One file, so that they are of one moment.
//
//   the picture      a PPM: "P6\n", width, height, 255, then red, green, blue
//   the state        as board::Performance has it: its layout (u32, little-endian), then its bytes
//   the end          32 bytes: "KAORI LF", the show (u64), bytes of picture and state (u32 each), and the
//                    checksum (u64, drivers/base/checksum.h) of all that stands before it
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "drivers/base/checksum.h"
#include "firmware/wire/bytes.h"

namespace kaori::last_face {

// The seal stands at the end, so that a file whose writing was cut short has none.
inline constexpr std::size_t kEnd_bytes = 32;
// A picture is 960 pixels wide at most, which makes 1.5 MB at 16 to 9; what is larger was not written by us
// and is not read.
inline constexpr std::size_t kLargest_bytes = std::size_t{1} << 21U;
inline constexpr std::array<std::uint8_t, 8> kMark{'K', 'A', 'O', 'R', 'I', ' ', 'L', 'F'};
// A show is known by so many bytes at its pack's beginning: its length and its checksum are among them.
inline constexpr std::size_t kShowMark_bytes = 64;

// What a file holds, or is to hold. Borrows the file's bytes, which must outlive it.
struct Content {
  std::uint64_t show = 0;  // Fnv1a(the pack's first kShowMark_bytes).
  std::span<const std::uint8_t> picture;
  std::span<const std::uint8_t> state;
};

using End = std::array<std::uint8_t, kEnd_bytes>;

// The last 32 bytes of a file that holds this picture and this state. The sum covers the seal's own fields
// before it, so that lengths or a show that were changed are found as well.
constexpr End EndOf(const Content& face) {
  End end{};
  std::copy(kMark.begin(), kMark.end(), end.begin());
  wire::PutU32(end, 8, static_cast<std::uint32_t>(face.show));
  wire::PutU32(end, 12, static_cast<std::uint32_t>(face.show >> 32U));
  wire::PutU32(end, 16, static_cast<std::uint32_t>(face.picture.size()));
  wire::PutU32(end, 20, static_cast<std::uint32_t>(face.state.size()));
  const std::uint64_t sum = Fnv1a(std::span(end).first(24), Fnv1a(face.state, Fnv1a(face.picture)));
  wire::PutU32(end, 24, static_cast<std::uint32_t>(sum));
  wire::PutU32(end, 28, static_cast<std::uint32_t>(sum >> 32U));
  return end;
}

// None where the file is torn, too large, or something else. The spans of the result point into `file`. The
// picture's own form and the state's layout are for the readers to check, and whether the show is the one
// that plays.
constexpr std::optional<Content> Read(std::span<const std::uint8_t> file) {
  if (file.size() < kEnd_bytes || file.size() > kLargest_bytes) return std::nullopt;
  const auto body = file.first(file.size() - kEnd_bytes);
  const auto end = file.last(kEnd_bytes);
  const std::size_t picture = wire::GetU32(end, 16), state = wire::GetU32(end, 20);
  // The lengths are compared without a sum of both: two lengths of 32 bits each could exceed a size_t of 32
  // bits.
  if (picture > body.size() || state != body.size() - picture) return std::nullopt;
  const Content face{.show = wire::GetU32(end, 8) | std::uint64_t{wire::GetU32(end, 12)} << 32U,
                     .picture = body.first(picture),
                     .state = body.last(state)};
  // One comparison checks the mark, the show, the lengths and the sum: the seal is made anew and must be the
  // same.
  const End wanted = EndOf(face);
  if (!std::equal(wanted.begin(), wanted.end(), end.begin())) return std::nullopt;
  return face;
}

}  // namespace kaori::last_face
