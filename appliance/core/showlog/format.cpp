#include "appliance/core/showlog/format.h"

#include <algorithm>

#include "drivers/base/checksum.h"
#include "firmware/wire/bytes.h"

namespace kaori::showlog {
namespace {

using Bytes = std::span<std::uint8_t>;
using ConstBytes = std::span<const std::uint8_t>;

// Places of the head and of a chunk, as format.h draws them; all numbers are little-endian.
constexpr std::size_t kHead_bytes = 60, kHeadOfVersion1_bytes = 56;  // Without the texts and the sum.
constexpr std::size_t kSum_bytes = 8;
constexpr std::size_t kChunkSumAt = kChunkHead_bytes - kSum_bytes;

// Whether the bytes begin with it; fewer bytes than the mark has do not.
bool HasMark(ConstBytes bytes, std::string_view mark) {
  return bytes.size() >= mark.size() && std::equal(mark.begin(), mark.end(), bytes.begin());
}

// Over the head but for the place of the sum itself, and then over the frames.
std::uint64_t ChunkSum(ConstBytes chunk) {
  return Fnv1a(chunk.subspan(kChunkHead_bytes), Fnv1a(chunk.first(kChunkSumAt)));
}

}  // namespace

// Two programs of one evening find the time of the box's start by subtracting two clocks, which is never
// quite the same; another evening differs by far more than a minute.
bool IsSameEvening(const LogHead& a, const LogHead& b) {
  return std::chrono::abs(a.booted_at - b.booted_at) < std::chrono::minutes(1);
}

// Texts that are longer than a reader accepts are cut, so that what is written can always be read.
std::vector<std::uint8_t> HeadBytes(const LogHead& head) {
  const std::size_t roles = std::min(head.roles.size(), kMostRoles_bytes);
  const std::size_t name = std::min(head.box.size(), kMostName_bytes);
  std::vector<std::uint8_t> bytes(kHead_bytes + roles + name + kSum_bytes);
  std::ranges::copy(kFileMark, bytes.begin());
  wire::PutU32(bytes, 8, kVersion);
  wire::PutU32(bytes, 12, static_cast<std::uint32_t>(bytes.size()));
  wire::PutU64(bytes, 16, head.layout);
  wire::PutU64(bytes, 24, head.program);
  wire::PutU64(bytes, 32, head.show);
  wire::PutU64(bytes, 40, static_cast<std::uint64_t>(head.booted_at.count()));
  wire::PutU32(bytes, 48, static_cast<std::uint32_t>(head.utc_offset_s));
  wire::PutU32(bytes, 52, static_cast<std::uint32_t>(roles));
  wire::PutU32(bytes, 56, static_cast<std::uint32_t>(name));
  const auto behind = std::copy_n(head.roles.begin(), roles, bytes.begin() + kHead_bytes);
  std::copy_n(head.box.begin(), name, behind);
  const std::size_t sum_at = bytes.size() - kSum_bytes;
  wire::PutU64(bytes, sum_at, Fnv1a(ConstBytes(bytes).first(sum_at)));
  return bytes;
}

// Lengths are compared with what is there before anything is read by them, and the sum before anything is
// believed: a log is cut off wherever the power went.
std::optional<HeadRead> ReadHead(ConstBytes file) {
  if (file.size() < kHead_bytes + kSum_bytes || !HasMark(file, kFileMark)) return std::nullopt;
  const std::uint32_t version = wire::GetU32(file, 8);
  if (version == 0 || version > kVersion) return std::nullopt;
  const std::size_t bytes = wire::GetU32(file, 12), roles = wire::GetU32(file, 52),
                    name = version == 1 ? 0 : wire::GetU32(file, 56),
                    texts_at = version == 1 ? kHeadOfVersion1_bytes : kHead_bytes;
  if (roles > kMostRoles_bytes || name > kMostName_bytes || bytes != texts_at + roles + name + kSum_bytes ||
      bytes > file.size())
    return std::nullopt;
  const std::size_t sum_at = bytes - kSum_bytes;
  if (wire::GetU64(file, sum_at) != Fnv1a(file.first(sum_at))) return std::nullopt;
  HeadRead read{.head = {.layout = wire::GetU64(file, 16),
                         .program = wire::GetU64(file, 24),
                         .show = wire::GetU64(file, 32),
                         .booted_at = Duration(static_cast<std::int64_t>(wire::GetU64(file, 40))),
                         .utc_offset_s = static_cast<std::int32_t>(wire::GetU32(file, 48))},
                .bytes = bytes};
  const auto own_roles = file.subspan(texts_at, roles), box = file.subspan(texts_at + roles, name);
  read.head.roles.assign(own_roles.begin(), own_roles.end());
  read.head.box.assign(box.begin(), box.end());
  return read;
}

// The sum comes last, over all that the others have written.
void SealChunk(const ChunkHead& head, Bytes chunk) {
  std::ranges::copy(kChunkMark, chunk.begin());
  wire::PutU32(chunk, 8, head.number);
  wire::PutU32(chunk, 12, head.bytes);
  wire::PutU32(chunk, 16, head.frames);
  wire::PutU32(chunk, 20, head.flags);
  wire::PutU32(chunk, 24, head.lost_frames);
  wire::PutU32(chunk, 28, 0);
  wire::PutU64(chunk, 32, static_cast<std::uint64_t>(head.first.time_since_epoch().count()));
  wire::PutU64(chunk, kChunkSumAt, ChunkSum(chunk));
}

// Of the chunk that begins where `file` does. What is cut short or spoilt anywhere in it is none.
std::optional<ChunkHead> ReadChunkHead(ConstBytes file) {
  if (file.size() < kChunkHead_bytes || !HasMark(file, kChunkMark)) return std::nullopt;
  const ChunkHead head{.number = wire::GetU32(file, 8),
                       .bytes = wire::GetU32(file, 12),
                       .frames = wire::GetU32(file, 16),
                       .flags = wire::GetU32(file, 20),
                       .lost_frames = wire::GetU32(file, 24),
                       .first = Time{} + Duration(static_cast<std::int64_t>(wire::GetU64(file, 32)))};
  if (head.bytes > kMostChunk_bytes || head.bytes > file.size() - kChunkHead_bytes) return std::nullopt;
  const auto chunk = file.first(kChunkHead_bytes + head.bytes);
  if (wire::GetU64(chunk, kChunkSumAt) != ChunkSum(chunk)) return std::nullopt;
  return head;
}

}  // namespace kaori::showlog
