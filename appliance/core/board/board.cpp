#include "appliance/core/board/board.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>

#include <fmt/format.h>

namespace kaori::board {
namespace {

constexpr mode_t kMode = 0660;  // The programs share a group; nobody else looks on.

using Head = std::array<std::uint32_t, kHeadWords>;

Head MakeHead() {
  Head head{};
  head[0] = kMagic;
  head[1] = kVersion;
  head[2] = static_cast<std::uint32_t>(LayoutHash());
  head[3] = static_cast<std::uint32_t>(LayoutHash() >> 32);
  head[4] = static_cast<std::uint32_t>(kBoardBytes);
  return head;
}

Result<void> CheckHead(int fd, const std::string& path) {
  struct stat status {};
  if (::fstat(fd, &status) < 0) return FailErrno("look at board " + path);
  Head head{};
  const ssize_t got = ::pread(fd, head.data(), sizeof(head), 0);
  if (got < 0) return FailErrno("read board " + path);
  const Head want = MakeHead();
  if (got < static_cast<ssize_t>(sizeof(head)) || head[0] != want[0])
    return FailInput("open board " + path + ": this file is no board");
  if (head[1] != want[1])
    return FailInput(
        fmt::format("open board {}: it has version {}, this program {}", path, head[1], want[1]));
  if (head[2] != want[2] || head[3] != want[3])
    return FailInput("open board " + path + ": its sections are laid out by another build");
  if (head[4] != want[4] || status.st_size != static_cast<off_t>(kBoardBytes))
    return FailInput(
        fmt::format("open board {}: it has {} bytes, not {}", path, status.st_size, kBoardBytes));
  return {};
}

// A whole board under a passing name, then linked to its place: nobody ever opens half a board.
Result<void> MakeFile(const std::string& path) {
  // A thread's id: no other maker has it, in this process or any.
  const std::string passing = fmt::format("{}.{}", path, ::gettid());
  ::unlink(passing.c_str());
  UniqueFd file(::open(passing.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kMode));
  if (!file.valid()) return FailErrno("make board " + passing);
  const Head head = MakeHead();
  const bool written =
      ::fchmod(file.get(), kMode) == 0 &&  // Whatever the umask: the group's other programs write to it.
      ::ftruncate(file.get(), static_cast<off_t>(kBoardBytes)) == 0 &&
      ::pwrite(file.get(), head.data(), sizeof(head), 0) == static_cast<ssize_t>(sizeof(head));
  if (!written) {
    auto failed = FailErrno("write board " + passing);
    ::unlink(passing.c_str());
    return failed;
  }
  const int linked = ::link(passing.c_str(), path.c_str());
  const int cause = errno;
  ::unlink(passing.c_str());
  if (linked < 0 && cause != EEXIST) return Fail(static_cast<std::errc>(cause), "make board " + path);
  return {};
}

bool SameFile(int a, int b) {
  struct stat first {};
  struct stat second {};
  return ::fstat(a, &first) == 0 && ::fstat(b, &second) == 0 && first.st_dev == second.st_dev &&
         first.st_ino == second.st_ino;
}

// Owned by the open file description, so it ends with the process, however that ends.
bool LockSection(int fd, const SectionPlace& place) {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = static_cast<off_t>(place.at_word * sizeof(Word));
  lock.l_len = static_cast<off_t>(SectionWords(place.value_words) * sizeof(Word));
  return ::fcntl(fd, F_OFD_SETLK, &lock) == 0;
}

}  // namespace

Result<Mapping> Mapping::Map(int fd, bool writable, const std::string& path) {
  const int protection = writable ? PROT_READ | PROT_WRITE : PROT_READ;
  void* at = ::mmap(nullptr, kBoardBytes, protection, MAP_SHARED, fd, 0);
  if (at == MAP_FAILED) return FailErrno("map board " + path);
  return Mapping(static_cast<Word*>(at));
}

Mapping::~Mapping() {
  if (words_ != nullptr) ::munmap(words_, kBoardBytes);
}

SectionWriter::SectionWriter(Section section, UniqueFd lock, Mapping mapping)
    : section_(section), lock_(std::move(lock)), mapping_(std::move(mapping)) {
  SetWriterPid(mapping_.words() + Place(section_).at_word, static_cast<std::uint32_t>(::getpid()));
}

void SectionWriter::Publish(std::span<const std::uint32_t> value) {
  board::Publish(mapping_.words() + Place(section_).at_word, value);
}

Result<Board> Board::Create(const std::string& path) {
  if (::access(path.c_str(), F_OK) != 0) {
    if (auto made = MakeFile(path); !made) return tl::unexpected(made.error());
  }
  return Open(path);
}

Result<Board> Board::Open(const std::string& path) {
  UniqueFd file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.valid()) return FailErrno("open board " + path);
  if (auto ok = CheckHead(file.get(), path); !ok) return tl::unexpected(ok.error());
  auto mapping = Mapping::Map(file.get(), /*writable=*/false, path);
  if (!mapping) return tl::unexpected(mapping.error());
  return Board(path, std::move(file), std::move(*mapping));
}

Result<SectionWriter> Board::AcquireSection(Section section) const {
  const SectionPlace& place = Place(section);
  const std::string attempt = fmt::format("write section {} of board {}", place.name, path_);
  UniqueFd lock(::open(path_.c_str(), O_RDWR | O_CLOEXEC));
  if (!lock.valid()) return FailErrno(attempt);
  if (!SameFile(lock.get(), file_.get()))
    return Fail(std::errc::no_such_file_or_directory, attempt + ": another file took its place");
  if (!LockSection(lock.get(), place)) {
    const std::uint32_t holder = WriterPid(mapping_.words() + place.at_word);
    return Fail(std::errc::device_or_resource_busy, fmt::format("{}: held by process {}", attempt, holder));
  }
  auto mapping = Mapping::Map(lock.get(), /*writable=*/true, path_);
  if (!mapping) return tl::unexpected(mapping.error());
  return SectionWriter(section, std::move(lock), std::move(*mapping));
}

bool Board::Fetch(Section section, std::uint32_t age, std::span<std::uint32_t> value) const {
  return board::Fetch(mapping_.words() + Place(section).at_word, age, value);
}

}  // namespace kaori::board
