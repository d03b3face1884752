// Writes a backup of a data partition, piece by piece, and reads it back.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "appliance/core/backup/reader.h"
#include "drivers/base/unique_fd.h"

namespace kaori::backup {

// Whose backup it is.
struct Head {
  std::string box, made;  // As in Contents.
};

// One thread. Each file is read twice, since the list stands before them; one that changed between the two is an error, and
// nothing is left then.
class Writer {
 public:
  // `file` is new. Errors: those of ListFolder and open(2): file_exists, no_space_on_device ...
  static Result<Writer> Begin(const std::filesystem::path& data, const Head& head, const std::filesystem::path& file);
  // A file that is not whole is removed with it.
  ~Writer();
  Writer(Writer&&) = default;
  Writer& operator=(Writer&&) = delete;

  // The next piece. True: the backup is on the stick, and was read back from it. Errors: those of read(2), write(2) and
  // fsync(2); bad_message, what was read back is not what was written; text_file_busy, a file of the box changed.
  Result<bool> Step();

 private:
  enum class Stage : std::uint8_t { kSum, kList, kCopy, kBack, kEnded };
  Writer(std::filesystem::path data, std::filesystem::path file) : data_(std::move(data)), name_(std::move(file)) {}
  Result<void> AddFiles();
  Result<void> OpenNext();
  Result<void> SumPiece();
  Result<void> WriteList();
  Result<void> CopyPiece();
  Result<void> Finish();
  Result<void> Write(std::span<const std::uint8_t> bytes);
  Result<std::size_t> ReadPiece();

  std::filesystem::path data_, name_;
  Contents contents_;
  Stage stage_ = Stage::kSum;
  std::size_t at_ = 0;  // Of the files, that is being read.
  std::unique_ptr<Input> source_;
  std::uint64_t read_bytes_ = 0;
  std::vector<std::uint8_t> piece_;
  Sha256 sum_;
  UniqueFd out_;
  std::optional<Reader> back_;
};

}  // namespace kaori::backup
