#include "appliance/core/board/board.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "appliance/core/board/board_file.h"

namespace kaori::board {
namespace {

// Owned by the open file description, so it ends with the process, however that ends. A lock of fcntl(2)
// without OFD would belong to the process: it would let a second writer of the same process in, and would be
// lost when any descriptor of the file is closed. The range is the section's own bytes, so that two sections
// of one file lock independently.
struct flock LockOf(const SectionPlace& place) {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = static_cast<off_t>(place.at_word * sizeof(Word));
  lock.l_len = static_cast<off_t>(SectionWords(place.value_words) * sizeof(Word));
  return lock;
}

bool LockSection(int fd, const SectionPlace& place) {
  struct flock lock = LockOf(place);
  return ::fcntl(fd, F_OFD_SETLK, &lock) == 0;
}

}  // namespace

namespace internal {

// A section that this process writes, wherever the board lies. It stays at its address, so that the board
// finds it.
class OwnSection {
 public:
  OwnSection(Section section, OwnSections& all)
      : section_(section), value_(Place(section).value_words), all_(&all) {
    all_->members.push_back(this);
  }
  OwnSection(const OwnSection&) = delete;
  OwnSection& operator=(const OwnSection&) = delete;
  ~OwnSection() {
    if (all_ != nullptr) std::erase(all_->members, this);
  }

  // Locks and maps the section in the file at `path`, where that is `board`'s. What was published before is
  // there at once. The file is opened again, since an open file description owns the lock, and its inode is
  // compared with the board's: between Heal's look and this one the file may have been replaced once more.
  // Nothing of the object changes before the lock is held; where this fails the old pages stay, and writing
  // goes on where it went before.
  Result<void> Move(const std::string& path, int board) {
    const std::string attempt = fmt::format("write section {} of board {}", Place(section_).name, path);
    UniqueFd lock(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    if (!lock.valid()) return FailErrno(attempt);
    if (!IsSameFile(lock.get(), board))
      return Fail(std::errc::no_such_file_or_directory, attempt + ": another file took its place");
    auto mapping = Mapping::Map(lock.get(), /*writable=*/true, path);
    if (!mapping) return tl::unexpected(mapping.error());
    Word* const words = mapping->words() + Place(section_).at_word;
    if (!LockSection(lock.get(), Place(section_)))
      return Fail(std::errc::device_or_resource_busy,
                  fmt::format("{}: held by process {}", attempt, WriterPid(words)));
    lock_ = std::move(lock);
    mapping_.emplace(std::move(*mapping));
    SetWriterPid(words, static_cast<std::uint32_t>(::getpid()));
    if (published_) board::Publish(words, value_);
    return {};
  }

  // Whether the section is written in the file that the descriptor `board` names.
  bool IsOn(int board) const { return lock_.valid() && IsSameFile(lock_.get(), board); }

  // Keeps a copy first, since only the writer can bring the value to a board that is made anew.
  void Publish(std::span<const std::uint32_t> value) {
    std::ranges::copy(value, value_.begin());
    published_ = true;
    board::Publish(mapping_->words() + Place(section_).at_word, value);
  }

  // The board object is gone: from now on nobody moves this section.
  void Orphan() { all_ = nullptr; }

 private:
  Section section_;
  UniqueFd lock_;  // An open file description of its own, which owns the byte-range lock.
  std::optional<Mapping> mapping_;
  std::vector<std::uint32_t> value_;  // Published last.
  bool published_ = false;
  OwnSections* all_;
};

OwnSections::~OwnSections() {
  for (OwnSection* section : members) section->Orphan();
}

}  // namespace internal

SectionWriter::SectionWriter(std::unique_ptr<internal::OwnSection> section) : section_(std::move(section)) {}
SectionWriter::SectionWriter(SectionWriter&&) noexcept = default;
SectionWriter& SectionWriter::operator=(SectionWriter&&) noexcept = default;
SectionWriter::~SectionWriter() = default;

void SectionWriter::Publish(std::span<const std::uint32_t> value) {
  section_->Publish(value);
}

Result<Board> Board::Create(const std::string& path) {
  return OpenOrMakeFile(path).and_then([&](UniqueFd file) { return Over(path, std::move(file)); });
}

Result<Board> Board::Open(const std::string& path) {
  return OpenFile(path).and_then([&](UniqueFd file) { return Over(path, std::move(file)); });
}

Result<Board> Board::Over(const std::string& path, UniqueFd file) {
  auto mapping = Mapping::Map(file.get(), /*writable=*/false, path);
  if (!mapping) return tl::unexpected(mapping.error());
  return Board(path, std::move(file), std::move(*mapping));
}

Result<SectionWriter> Board::AcquireSection(Section section) const {
  auto own = std::make_unique<internal::OwnSection>(section, *own_);
  if (auto moved = own->Move(path_, file_.get()); !moved) return tl::unexpected(moved.error());
  return SectionWriter(std::move(own));
}

// The board moves before its writers do, so that whoever reads the moves() sees the new pages; a writer that
// cannot follow yet, since another process has not let go of its lock, is tried again at the next call. Two
// looks are needed, since each sees what the other cannot: intact() sees pages that the kernel took away, and
// the inode sees a file that was replaced while ours is still whole.
Result<bool> Board::Heal() {
  auto file = OpenOrMakeFile(path_);
  if (!file) return tl::unexpected(file.error());
  const bool moves = !intact() || !IsSameFile(file->get(), file_.get());
  if (moves) {
    auto mapping = Mapping::Map(file->get(), /*writable=*/false, path_);
    if (!mapping) return tl::unexpected(mapping.error());
    file_ = std::move(*file);
    mapping_ = std::move(*mapping);
    ++moves_;
  }
  Result<bool> outcome = moves;
  for (internal::OwnSection* section : own_->members) {
    if (section->IsOn(file_.get())) continue;
    if (auto moved = section->Move(path_, file_.get()); !moved) outcome = tl::unexpected(moved.error());
  }
  return outcome;
}

// A relaxed load is enough: the word never changes on a whole board, and on a lost one it is zero for good.
bool Board::intact() const {
  return mapping_.words()[0].load(std::memory_order_relaxed) == kMagic;
}

bool Board::Fetch(Section section, std::uint32_t age, std::span<std::uint32_t> value) const {
  return board::Fetch(mapping_.words() + Place(section).at_word, age, value);
}

// Asks by the descriptor of the reader, which owns no lock itself: so writers of this process are found as well. F_OFD_GETLK
// sets the type to F_UNLCK where the lock could be had, and locks nothing.
bool Board::HasWriter(Section section) const {
  struct flock lock = LockOf(Place(section));
  return ::fcntl(file_.get(), F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

}  // namespace kaori::board
