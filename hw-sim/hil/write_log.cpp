#include "hw-sim/hil/write_log.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "firmware/wire/bytes.h"
#include "hw-sim/hil/disk_copy.h"

namespace kaori::hil {
namespace {

// The kernel's Documentation/admin-guide/device-mapper/log-writes.rst, in sectors of 512 bytes: a head, then each entry in a
// sector of its own, with what was written behind it.
constexpr std::uint64_t kLogMagic = 0x6a736677736872, kLogVersion = 1, kLogSector_bytes = 512;
constexpr std::uint64_t kSaysFlush = 1, kSaysDiscard = 4;  // Flags of an entry.
// A machine never writes more at once; a number above it is none.
constexpr std::uint64_t kMostAtOnce_bytes = std::uint64_t{1} << 30U;

// Nothing at the file's end.
bool ReadSector(std::ifstream& file, std::uint64_t at, std::array<std::uint8_t, kLogSector_bytes>& sector) {
  file.clear();
  file.seekg(static_cast<std::streamoff>(at));
  return static_cast<bool>(file.read(reinterpret_cast<char*>(sector.data()), sector.size()));
}

}  // namespace

// A write that reaches beyond is not held: it changes something else as well.
bool DiskSpan::Holds(const LoggedWrite& write) const {
  return write.at_bytes >= at_bytes && write.at_bytes + write.bytes <= at_bytes + bytes;
}

bool DiskSpan::Meets(const LoggedWrite& write) const {
  return write.at_bytes < at_bytes + bytes && at_bytes < write.at_bytes + write.bytes;
}

std::string DecisionFault(const std::vector<LoggedWrite>& entries, const std::vector<DiskSpan>& before,
                          const DiskSpan& deciding) {
  bool decided = false;
  int unflushed = 0;
  for (const LoggedWrite& write : entries) {
    if (write.bytes == 0) {
      unflushed = 0;
    } else if (deciding.Meets(write)) {
      if (!deciding.Holds(write)) return "the write that decides changes something else as well";
      if (std::exchange(decided, true)) return "what decides is written twice";
      if (unflushed > 0) return fmt::format("{} writes have not been flushed when it decides", unflushed);
    } else if (std::ranges::any_of(before, [&](const DiskSpan& span) { return span.Meets(write); })) {
      if (decided) return "it writes on after it has decided";
      ++unflushed;
    }
  }
  return decided ? "" : "nothing decides";
}

// QEMU writes the head at each flush: before the first one there is none.
Result<WriteLog> WriteLog::Read(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return Fail(std::errc::no_such_file_or_directory, "open " + path);
  const auto length = static_cast<std::uint64_t>(file.tellg());
  std::array<std::uint8_t, kLogSector_bytes> sector{};
  const bool has_head =
      ReadSector(file, 0, sector) && std::ranges::any_of(sector, [](auto byte) { return byte != 0; });
  if (has_head && (wire::GetU64(sector, 0) != kLogMagic || wire::GetU64(sector, 8) != kLogVersion ||
                   wire::GetU32(sector, 24) != kLogSector_bytes))
    return FailInput(path + " is no log of writes");
  std::vector<LoggedWrite> entries;
  for (std::uint64_t at = kLogSector_bytes; ReadSector(file, at, sector);) {
    const std::uint64_t where = wire::GetU64(sector, 0), count = wire::GetU64(sector, 8),
                        flags = wire::GetU64(sector, 16);
    const std::uint64_t size = count * kLogSector_bytes;
    if (count > kMostAtOnce_bytes / kLogSector_bytes) break;
    at += kLogSector_bytes;
    if ((flags & kSaysFlush) != 0) entries.push_back({});
    // A discard has no content, and no disk has to do anything about it.
    if ((flags & kSaysDiscard) != 0) continue;
    if (at + size > length) break;
    if (size > 0) entries.push_back({where * kLogSector_bytes, size, at});
    at += size;
  }
  return WriteLog(path, std::move(entries));
}

// A flush lies nowhere.
bool WriteLog::WritesInto(const DiskSpan& span) const {
  return std::ranges::any_of(entries_,
                             [&](const auto& write) { return write.bytes > 0 && span.Holds(write); });
}

std::uint64_t WriteLog::SectorsOutside(const std::vector<DiskSpan>& spans) const {
  std::uint64_t sectors = 0;
  for (const LoggedWrite& write : entries_)
    if (std::ranges::none_of(spans, [&](const auto& span) { return span.Holds(write); }))
      sectors += write.bytes / kLogSector_bytes;
  return sectors;
}

Result<std::string> WriteLog::Content(const LoggedWrite& write) const {
  return ReadPart(file_, {.at_bytes = write.content_at, .bytes = write.bytes});
}

Result<void> WriteLog::Put(const LoggedWrite& write, const std::string& disk) const {
  const auto content = Content(write);
  if (!content) return tl::unexpected(content.error());
  return WritePart(disk, write.at_bytes, *content);
}

// In the order in which the machine's disk finished them.
Result<void> WriteLog::Replay(std::size_t from, std::size_t until, const std::string& disk) const {
  for (std::size_t n = from; n < until; ++n)
    if (entries_[n].bytes > 0)
      if (auto ok = Put(entries_[n], disk); !ok) return ok;
  return {};
}

}  // namespace kaori::hil
