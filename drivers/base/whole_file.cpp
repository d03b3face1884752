#include "drivers/base/whole_file.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>

#include "drivers/base/unique_fd.h"

namespace kaori {
namespace {

// A file that is being written: without a name, or under a name that nobody looks for.
struct Draft {
  UniqueFd fd;
  std::string name;  // Empty: none yet.

  Draft() = default;
  Draft(Draft&&) = default;
  Draft& operator=(Draft&&) = delete;
  ~Draft() {
    if (!name.empty()) ::unlink(name.c_str());
  }
};

using Chance = std::array<std::uint8_t, 6>;

// Good enough for a name, and never waited for: early in a start std::random_device would wait a second until
// the kernel has gathered randomness for keys, where the processor has no instruction that makes it. A kernel
// before 5.6 does not know GRND_INSECURE.
Chance DrawChance() {
  Chance chance{};
  if (::getrandom(chance.data(), chance.size(), GRND_INSECURE) == ssize_t{chance.size()}) return chance;
  std::random_device device;
  for (std::uint8_t& byte : chance) byte = static_cast<std::uint8_t>(device());
  return chance;
}

// Six letters, as of mkstemp(3). A name that is taken makes O_EXCL
// or linkat(2) fail; nothing is overwritten.
std::string FreshName(const std::string& file) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::string name = file + ".";
  for (const std::uint8_t byte : DrawChance()) name += kLetters[byte % kLetters.size()];
  return name;
}

std::string FolderOf(const std::filesystem::path& file) {
  const std::string folder = file.parent_path().string();
  return folder.empty() ? "." : folder;
}

Result<Draft> Begin(const std::filesystem::path& file, unsigned mode) {
  Draft draft;
  draft.fd = UniqueFd(::open(FolderOf(file).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode));
  if (draft.fd.valid()) return draft;
  // File systems without O_TMPFILE say EOPNOTSUPP; a kernel that does not know the flag sees an
  // attempt to open a folder for writing and says EISDIR (open(2)).
  if (errno != EOPNOTSUPP && errno != EISDIR) return FailErrno("write " + file.string());
  std::string name = FreshName(file.string());
  draft.fd = UniqueFd(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
  if (!draft.fd.valid()) return FailErrno("write " + file.string());
  draft.name = std::move(name);
  return draft;
}

// linkat(2) cannot replace a file, so a draft gets a name of its own first. Naming
// a file by its descriptor (AT_EMPTY_PATH) needs a capability that the box's
// programs do not have; the way by /proc needs none.
Result<void> GiveName(Draft& draft, const std::filesystem::path& file) {
  if (draft.name.empty()) {
    std::string name = FreshName(file.string());
    const std::string open_file = "/proc/self/fd/" + std::to_string(draft.fd.get());
    if (::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) < 0)
      return FailErrno("write " + file.string());
    draft.name = std::move(name);
  }
  if (std::rename(draft.name.c_str(), file.c_str()) < 0) return FailErrno("write " + file.string());
  draft.name.clear();
  return {};
}

UniqueFd OpenAsFolder(const std::filesystem::path& folder) {
  return UniqueFd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

}  // namespace

Result<void> WriteAll(int fd, std::span<const std::uint8_t> bytes, const std::string& name) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return FailErrno("write " + name);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

// A draft with a name is removed where a step fails, by its destructor.
Result<void> WriteWholeFile(const std::filesystem::path& file,
                            std::initializer_list<std::span<const std::uint8_t>> pieces, unsigned mode) {
  auto draft = Begin(file, mode);
  if (!draft) return tl::unexpected(draft.error());
  for (const auto& piece : pieces)
    if (auto ok = WriteAll(draft->fd.get(), piece, file.string()); !ok) return ok;
  if (::fsync(draft->fd.get()) < 0) return FailErrno("write " + file.string());
  // In this order: content, then name, then folder. A name that reached the disk before its
  // content would be an empty file after a loss of power.
  if (auto ok = GiveName(*draft, file); !ok) return ok;
  // A loss of power must not lose the name either: rename(2) changes the folder.
  return SyncFolder(FolderOf(file));
}

Result<void> SyncFolder(const std::filesystem::path& folder) {
  const UniqueFd fd = OpenAsFolder(folder);
  if (!fd.valid() || ::fsync(fd.get()) < 0) return FailErrno("write the folder " + folder.string());
  return {};
}

Result<void> SyncFileSystem(const std::filesystem::path& folder) {
  const UniqueFd fd = OpenAsFolder(folder);
  if (!fd.valid() || ::syncfs(fd.get()) < 0) return FailErrno("write " + folder.string());
  return {};
}

}  // namespace kaori
