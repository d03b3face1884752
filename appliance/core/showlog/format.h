// The file of a show log: a head, and chunks that stand each for itself. All numbers are little-endian.
//
//   head    "KAORILOG", version (u32), its length in bytes (u32), layout of the words (u64, WordsLayout), program (u64), show
//           (u64), when the machine was started by the wall clock (i64, ns since 1970, UTC), how far the wall clock is ahead
//           of UTC (i32, s), bytes of the roles (u32), bytes of the name (u32, from version 2 on), the box's own roles.toml,
//           the box's name, and a checksum (u64) of all before it
//   chunk   "KLOGPART", number (u32), bytes behind its head (u32), frames (u32), flags (u32), frames lost before it (u32), 0
//           (u32), when its first frame was presented (i64, ns of CLOCK_MONOTONIC), a checksum (u64) of the head before it
//           and of what follows; then its frames
//   frame   one byte: bit 0: the state that it was given stands behind it; bit 1: what was seen and the events are not among
//           its words, since performance::ReadEvents makes them of the board and of what the frame before had seen; the
//           change of the frame's words (frame_encoding.h) since the frame before, of which the first counts from 0; the
//           state's words where they stand there, as a change from 0; the sum of what was shown (u16, output_sum.h)
//
// A chunk begins with the whole state, so that a log plays from any of them, and one that is spoilt costs 30
// s. The checksum is that of drivers/base/checksum.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/showlog/change.h"
#include "appliance/core/showlog/frame_encoding.h"
#include "drivers/base/clock.h"

namespace kaori::showlog {

inline constexpr std::string_view kFileMark = "KAORILOG", kChunkMark = "KLOGPART";
inline constexpr std::uint32_t kVersion = 2;  // Version 1 is read too.
inline constexpr std::size_t kMostRoles_bytes = std::size_t{64} << 10U, kMostName_bytes = 64;
// A file that has this length is followed by another one; the reader refuses what is a chunk longer.
inline constexpr std::size_t kFullFile_bytes = std::size_t{32} << 20U;
inline constexpr std::size_t kMostChunk_bytes = std::size_t{512} << 10U;
inline constexpr std::size_t kChunkHead_bytes = 48;
inline constexpr Duration kChunkTime = std::chrono::seconds(30);
// A frame that has everything: its kind, both changes, its sum.
inline constexpr std::size_t kMostFrame_bytes =
    1 + MostChange_bytes(kFrameWords) + MostChange_bytes(kStateWords) + 2;
static_assert(kChunkHead_bytes + 2 * kMostFrame_bytes < kMostChunk_bytes);

// A chunk goes on where the one before it ended: nothing lies between them.
inline constexpr std::uint32_t kContinues = 1U << 0U;
inline constexpr std::uint8_t kWithState = 1U << 0U, kEventsOfBoard = 1U << 1U;

// What a log is of.
struct LogHead {
  std::uint64_t layout = WordsLayout();
  std::uint64_t program = 0;  // A checksum of the program's file.
  std::uint64_t show = 0;     // A checksum of how its pack begins, and so of its content.
  Duration
      booted_at{};  // CLOCK_MONOTONIC's 0 on the wall clock, since 1970, UTC. Tells one evening from another.
  std::int32_t utc_offset_s = 0;
  std::string roles{};  // The box's own roles.toml; empty: the show's roles play.
  std::string box{};    // The box that played, as store/box_name.h has it; empty where that is not known.
};

// Whether both are of one start of the box; a wall clock that was set by less than a minute between them
// changes nothing.
bool IsSameEvening(const LogHead& a, const LogHead& b);

std::vector<std::uint8_t> HeadBytes(const LogHead& head);

struct HeadRead {
  LogHead head;
  std::size_t bytes = 0;  // Of the head in the file.
};
// Nothing where the bytes do not begin with a whole head of this version.
std::optional<HeadRead> ReadHead(std::span<const std::uint8_t> file);

// What stands before a chunk's frames. Numbers count the chunks of one run of the stage, over all files of
// its log; lost frames are those that came before this chunk and were never handed to the disk.
struct ChunkHead {
  std::uint32_t number = 0;
  std::uint32_t bytes = 0;  // Of its frames.
  std::uint32_t frames = 0;
  std::uint32_t flags = 0;
  std::uint32_t lost_frames = 0;
  Time first{};
};

// Writes the head in front of the frames; `chunk` is both. Allocates nothing.
void SealChunk(const ChunkHead& head, std::span<std::uint8_t> chunk);
// Nothing where no whole chunk begins there.
std::optional<ChunkHead> ReadChunkHead(std::span<const std::uint8_t> file);

}  // namespace kaori::showlog
