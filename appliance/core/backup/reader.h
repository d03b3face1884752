// Reads a backup from front to back, once, and believes nothing of it that its list does not say and its checksums do
// not prove.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>

#include "appliance/core/backup/contents.h"
#include "appliance/core/backup/sha256.h"

namespace kaori::backup {

// A backup's bytes: a file on a stick, which may go at any moment, or what a test gives.
class Input {
 public:
  virtual ~Input() = default;
  // Fills `into` as far as the file goes, and says how far. Errors: those of read(2).
  virtual Result<std::size_t> Read(std::span<std::uint8_t> into) = 0;
};

// Errors: those of open(2); kNoBackup for what is no regular file.
Result<std::unique_ptr<Input>> OpenInput(const std::filesystem::path& file);

// Gets the files of a backup, in their order. An error ends the reading with it.
class Sink {
 public:
  virtual ~Sink() = default;
  virtual Result<void> Begin(const Entry& entry) = 0;
  virtual Result<void> Append(std::span<const std::uint8_t> bytes) = 0;
  // The file is whole, and its checksum fits.
  virtual Result<void> End(const Entry& entry) = 0;
};

// One thread. Errors of both calls: those of ParseContents, kCutOffBackup, invalid_argument (a checksum or a header does not
// fit); of kind kSystem what the input has.
class Reader {
 public:
  // Reads the list.
  static Result<Reader> Begin(std::unique_ptr<Input> input);
  const Contents& contents() const { return contents_; }
  // The next piece of a file, kPiece_bytes at most. True: that was the last one, and nothing follows on it.
  Result<bool> Step(Sink& sink);

  static constexpr std::size_t kPiece_bytes = std::size_t{1} << 20U;

 private:
  explicit Reader(std::unique_ptr<Input> input) : input_(std::move(input)) {}
  Result<void> ReadAll(std::span<std::uint8_t> into);
  Result<Member> ReadHeader();
  Result<void> ReadContents();
  Result<void> BeginFile(Sink& sink);
  Result<void> EndFile(Sink& sink);
  Result<void> ReadEnd();

  std::unique_ptr<Input> input_;
  Contents contents_;
  std::size_t file_ = 0;  // Of contents_, that is being read.
  bool begun_ = false;
  std::uint64_t left_bytes_ = 0;
  Sha256 sum_;
};

}  // namespace kaori::backup
