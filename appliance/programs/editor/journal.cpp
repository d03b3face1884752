#include "appliance/programs/editor/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>

namespace kaori::editor {
namespace {

// The file begins with this and the fingerprint of the control points. The last letter is the format's
// version.
constexpr std::array<char, 8> kMagic{'K', 'A', 'O', 'R', 'I', 'N', 'J', '1'};
constexpr std::size_t kHeadBytes = kMagic.size() + sizeof(std::uint64_t);
// More than any session writes; a journal that is larger is read to here and cut off.
constexpr std::uint64_t kMostBytes = 256U << 20U;

// The fingerprint is written as it lies in memory, as everything in a record is (record.cpp).
std::array<std::uint8_t, kHeadBytes> HeadOf(std::uint64_t fingerprint) {
  std::array<std::uint8_t, kHeadBytes> head{};
  std::memcpy(head.data(), kMagic.data(), kMagic.size());
  std::memcpy(head.data() + kMagic.size(), &fingerprint, sizeof fingerprint);
  return head;
}

// The lock keeps two editors from writing into one file. It belongs to the descriptor and ends with the
// process.
Result<UniqueFd> OpenLocked(const std::filesystem::path& file) {
  UniqueFd fd(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (!fd.valid()) return FailErrno("open " + file.string());
  if (::flock(fd.get(), LOCK_EX | LOCK_NB) == 0) return fd;
  return Fail(std::errc::device_or_resource_busy, "open " + file.string());
}

// pread leaves the descriptor's position alone; a file that shrinks meanwhile gives what it has.
Result<std::vector<std::uint8_t>> ReadAll(int fd, const std::string& name) {
  struct stat status {};
  if (::fstat(fd, &status) < 0) return FailErrno("read " + name);
  std::vector<std::uint8_t> bytes(std::min(static_cast<std::uint64_t>(status.st_size), kMostBytes));
  std::size_t have = 0;
  while (have < bytes.size()) {
    const ssize_t got = ::pread(fd, bytes.data() + have, bytes.size() - have, static_cast<off_t>(have));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return FailErrno("read " + name);
    if (got == 0) break;
    have += static_cast<std::size_t>(got);
  }
  bytes.resize(have);
  return bytes;
}

// Returns when the bytes are on the disk. The file's length is part of what fdatasync writes.
Result<void> WriteAt(int fd, std::uint64_t at, std::span<const std::uint8_t> bytes, const std::string& name) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(fd, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return FailErrno("write " + name);
    at += static_cast<std::uint64_t>(written);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  if (::fdatasync(fd) < 0) return FailErrno("write " + name);
  return {};
}

bool BeginsWith(std::span<const std::uint8_t> bytes, std::span<const std::uint8_t> head) {
  return bytes.size() >= head.size() && std::equal(head.begin(), head.end(), bytes.begin());
}

// Where the journal of a cast waits while another cast is played: named by what its own head says.
std::string AsideOf(const std::filesystem::path& file, std::span<const std::uint8_t> head) {
  std::string name = file.string() + '.';
  for (const std::uint8_t byte : head.subspan(kMagic.size(), sizeof(std::uint64_t)))
    name += fmt::format("{:02x}", byte);
  return name;
}

// Keeps the file that is there aside, where it holds work, and brings back the one of `head`, where it waits.
// Returns whether another file is there now.
Result<bool> Exchange(const std::filesystem::path& file, std::span<const std::uint8_t> bytes,
                      std::span<const std::uint8_t> head) {
  const std::string waiting = AsideOf(file, head);
  const bool waits = ::access(waiting.c_str(), F_OK) == 0;
  const bool holds_work = bytes.size() > kHeadBytes;
  if (holds_work && std::rename(file.c_str(), AsideOf(file, bytes).c_str()) < 0)
    return FailErrno("keep aside " + file.string());
  if (waits && std::rename(waiting.c_str(), file.c_str()) < 0) return FailErrno("take up " + waiting);
  return waits || holds_work;
}

}  // namespace

// After an exchange another file stands under the name, which has to be opened and locked anew.
Result<Journal::Opened> Journal::Open(const std::filesystem::path& file, std::uint64_t fingerprint) {
  auto fd = OpenLocked(file);
  if (!fd) return tl::unexpected(fd.error());
  auto bytes = ReadAll(fd->get(), file.string());
  if (!bytes) return tl::unexpected(bytes.error());
  const auto head = HeadOf(fingerprint);
  const bool aside = !BeginsWith(*bytes, head) && bytes->size() > kHeadBytes;  // Less is nobody's work.
  auto changed = BeginsWith(*bytes, head) ? Result<bool>(false) : Exchange(file, *bytes, head);
  if (!changed) return tl::unexpected(changed.error());
  if (*changed) {
    fd = OpenLocked(file);
    bytes = fd ? ReadAll(fd->get(), file.string()) : tl::unexpected(fd.error());
    if (!bytes) return tl::unexpected(bytes.error());
  }
  Opened opened{Journal(std::move(*fd), file, fingerprint), {}, 0, aside};
  if (!BeginsWith(*bytes, head)) return opened;  // The first record brings the head: a full disk can wait.
  Decoded decoded = Decode(std::span(*bytes).subspan(kHeadBytes));
  opened.records = std::move(decoded.records);
  opened.journal.end_ = kHeadBytes + decoded.sound_bytes;
  opened.torn_bytes = bytes->size() - opened.journal.end_;
  return opened;
}

// `end_` moves only when all of it is on the disk. A crash in between leaves bytes behind the end, which the
// next Open finds torn and the next Append cuts off.
Result<void> Journal::Append(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> all;
  if (end_ == 0) {
    const auto head = HeadOf(fingerprint_);
    all.assign(head.begin(), head.end());
  }
  all.insert(all.end(), bytes.begin(), bytes.end());
  auto written = CutOff();  // What an earlier attempt or a crash left behind the end.
  if (written) written = WriteAt(fd_.get(), end_, all, file_.string());
  if (written)
    end_ += all.size();
  else
    static_cast<void>(CutOff());  // Else before the next record.
  return written;
}

// The head stays where there is one.
Result<void> Journal::Clear() {
  end_ = std::min<std::uint64_t>(end_, kHeadBytes);
  return CutOff();
}

// Everything behind `end_` is of no record that counts.
Result<void> Journal::CutOff() {
  if (::ftruncate(fd_.get(), static_cast<off_t>(end_)) < 0) return FailErrno("write " + file_.string());
  return {};
}

}  // namespace kaori::editor
