#include "appliance/core/board/board_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <span>

#include <fmt/format.h>

#include "appliance/core/board/layout.h"

namespace kaori::board {
namespace {

constexpr mode_t kMode = 0660;  // The programs share a group; nobody else looks on.

using Head = std::array<std::uint32_t, kHeadWords>;

// The head that this build writes and expects. layout.h says what each word means.
Head MakeHead() {
  Head head{};
  head[0] = kMagic;
  head[1] = kVersion;
  head[2] = static_cast<std::uint32_t>(LayoutHash());
  head[3] = static_cast<std::uint32_t>(LayoutHash() >> 32);
  head[4] = static_cast<std::uint32_t>(kBoardBytes);
  head[kHeadSumAt] = HeadSum(std::span(head).first<kHeadSumAt>());
  return head;
}

// A file that has neither a board's first word nor its size is somebody's, and not a spoilt board; an empty
// one is nobody's. OpenOrMakeFile replaces no file that this does not accept, so that a path given by
// mistake costs nobody a file.
bool WasBoard(const Head& head, off_t size) {
  return size == 0 || size == static_cast<off_t>(kBoardBytes) || head[0] == kMagic;
}

// The order of the checks decides what OpenOrMakeFile does. A file that never was a board is refused first;
// damage (bad_message) is found before versions are compared, since the words of a damaged head mean nothing;
// a sound board of another build is refused and left alone, since its programs still use it. The size is
// last: a sound head over a file that was cut short is damage too.
Result<void> Check(int fd, const std::string& path) {
  struct stat status {};
  if (::fstat(fd, &status) < 0) return FailErrno("look at board " + path);
  Head head{};
  if (::pread(fd, head.data(), sizeof(head), 0) < 0) return FailErrno("read board " + path);
  const Head want = MakeHead();
  if (!S_ISREG(status.st_mode) || !WasBoard(head, status.st_size))
    return FailInput("open board " + path + ": this file is no board");
  if (head[0] != kMagic || head[kHeadSumAt] != HeadSum(std::span(head).first<kHeadSumAt>()))
    return FailInput("open board " + path + ": its head is spoilt", std::errc::bad_message);
  if (head[1] != want[1])
    return FailInput(
        fmt::format("open board {}: it has version {}, this program {}", path, head[1], want[1]));
  if (head[2] != want[2] || head[3] != want[3])
    return FailInput("open board " + path + ": its sections are laid out by another build");
  if (status.st_size != static_cast<off_t>(kBoardBytes))
    return FailInput(fmt::format("open board {}: it has {} bytes, not {}", path, status.st_size, kBoardBytes),
                     std::errc::bad_message);
  return {};
}

// Makes an empty file a whole board whose sections are all absent. Gives 0 or an errno. Its blocks are
// reserved from the start (posix_fallocate gives zeros): a full disk is told here, and not by SIGBUS at the
// first write.
int Fill(int fd) {
  const Head head = MakeHead();
  // Whatever the umask: the group's other programs write to it.
  if (::fchmod(fd, kMode) < 0) return errno;
  if (const int cause = ::posix_fallocate(fd, 0, static_cast<off_t>(kBoardBytes)); cause != 0) return cause;
  return ::pwrite(fd, head.data(), sizeof(head), 0) == static_cast<ssize_t>(sizeof(head)) ? 0 : EIO;
}

// Makes a whole board under a passing name, which `put` then moves to `path`, so that nobody ever opens half
// a board. link(2) as `put` gives up where a file is there (EEXIST: another program was quicker, and its
// board is as good); rename(2) replaces a spoilt board in one step. The passing name is removed in each case.
Result<void> Make(const std::string& path, int (*put)(const char* passing, const char* path)) {
  // A thread's id: no other maker has it, in this process or any.
  const std::string passing = fmt::format("{}.{}", path, ::gettid());
  ::unlink(passing.c_str());
  UniqueFd file(::open(passing.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kMode));
  if (!file.valid()) return FailErrno("make board " + passing);
  int cause = Fill(file.get());
  if (cause == 0 && put(passing.c_str(), path.c_str()) < 0) cause = errno;
  ::unlink(passing.c_str());
  if (cause != 0 && cause != EEXIST) return Fail(static_cast<std::errc>(cause), "make board " + path);
  return {};
}

}  // namespace

// O_NONBLOCK: a path that names a pipe must not make a program wait for whoever writes to it.
Result<UniqueFd> OpenFile(const std::string& path) {
  UniqueFd file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.valid()) return FailErrno("open board " + path);
  if (auto ok = Check(file.get(), path); !ok) return tl::unexpected(ok.error());
  return file;
}

// Two programs that find the same spoilt board may both replace it. The one whose board was replaced in turn
// sees so at its next look, as it would see any other.
Result<UniqueFd> OpenOrMakeFile(const std::string& path) {
  auto file = OpenFile(path);
  if (file) return file;
  Result<void> made;
  if (file.error().cause == std::errc::no_such_file_or_directory)
    made = Make(path, ::link);
  else if (file.error().cause == std::errc::bad_message)
    made = Make(path, ::rename);
  else
    return file;
  if (!made) return tl::unexpected(made.error());
  return OpenFile(path);
}

bool IsSameFile(int a, int b) {
  struct stat first {};
  struct stat second {};
  return ::fstat(a, &first) == 0 && ::fstat(b, &second) == 0 && first.st_dev == second.st_dev &&
         first.st_ino == second.st_ino;
}

}  // namespace kaori::board
