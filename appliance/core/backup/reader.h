// Reads a backup from front to back, once, and believes nothing of it that its list does not say and its checksums do
// not prove.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "appliance/core/backup/contents.h"
#include "appliance/core/backup/sha256.h"
#include "drivers/base/unique_fd.h"

namespace kaori::backup {

// A backup's bytes: a file on a stick, which may go at any moment, or what a test gives. Used by one thread.
class Input {
 public:
  virtual ~Input() = default;
  // Fills `into` as far as the file goes, and says how far: less than all of it only at the file's end. Blocks for the
  // disk. Errors: those of read(2), which are of kind kSystem, as of a stick that was pulled.
  virtual Result<std::size_t> Read(std::span<std::uint8_t> into) = 0;
};

// A file of a stick, or of the box. Links are not followed, and nobody is waited for. Errors: those of open(2); kNoBackup
// for what is no regular file.
Result<std::unique_ptr<Input>> OpenInput(const std::filesystem::path& file);

// Of a file that somebody has opened for reading, from its beginning; `name` stands in errors. Errors: those of fstat(2) and
// lseek(2); kNoBackup for what is no regular file.
Result<std::unique_ptr<Input>> InputOf(UniqueFd file, const std::string& name);

// Gets the files of a backup, in their order: for each of them Begin, Append until it is whole, End. Whoever keeps what
// comes must not believe it before End. An error ends the reading with it.
class Sink {
 public:
  virtual ~Sink() = default;
  // The file that comes now: its path is one of a backup's, its length within the limits.
  virtual Result<void> Begin(const Entry& entry) = 0;
  // The next bytes of it, 1 MiB at most; borrowed for the call.
  virtual Result<void> Append(std::span<const std::uint8_t> bytes) = 0;
  // The file is whole, and its checksum fits.
  virtual Result<void> End(const Entry& entry) = 0;
};

// One thread. Errors of both calls: those of ParseContents, kCutOffBackup, invalid_argument (a checksum or a header does not
// fit); of kind kSystem what the input has.
class Reader {
 public:
  // Reads the list, and nothing behind it: whoever wants to know first what is in a backup reads no more.
  static Result<Reader> Begin(std::unique_ptr<Input> input);
  const Contents& contents() const { return contents_; }
  // The next piece of a file, kPiece_bytes at most. True: that was the last one, and nothing follows on it.
  Result<bool> Step(Sink& sink);

  static constexpr std::size_t kPiece_bytes = std::size_t{1} << 20U;

 private:
  explicit Reader(std::unique_ptr<Input> input) : input_(std::move(input)) {}
  // All of `into`, or kCutOffBackup.
  Result<void> ReadAll(std::span<std::uint8_t> into);
  // The header of a member; an archive that ends here is cut off.
  Result<Member> ReadHeader();
  Result<void> ReadContents();
  // The header of the next file, compared with the list, and its end.
  Result<void> BeginFile(Sink& sink);
  Result<void> EndFile(Sink& sink);
  // The archive's end, behind which nothing may follow.
  Result<void> ReadEnd();

  std::unique_ptr<Input> input_;
  Contents contents_;
  // Of contents_, that is being read.
  std::size_t file_ = 0;
  // Its header was read; so much of it is still to come, and what came has this checksum.
  bool begun_ = false;
  std::uint64_t left_bytes_ = 0;
  Sha256 sum_;
};

}  // namespace kaori::backup
