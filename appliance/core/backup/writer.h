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
  // As in Contents.
  std::string box, made;
};

// One thread. Each file is read twice, since the list stands before them; one that changed between the two is an error, and
// nothing is left then. Of a report, which grows while a show plays, the backup has as much as there was at first.
class Writer {
 public:
  // `file` is new. Errors: those of ListFolder and open(2): file_exists, no_space_on_device ...
  static Result<Writer> Begin(const std::filesystem::path& data, const Head& head,
                              const std::filesystem::path& file);
  // A file that is not whole is removed with it.
  ~Writer();
  Writer(Writer&&) = default;
  Writer& operator=(Writer&&) = delete;

  // The next piece. True: the backup is on the stick, and was read back from it. Errors: those of read(2), write(2) and
  // fsync(2); bad_message, what was read back is not what was written; text_file_busy, a file of the box changed.
  Result<bool> Step();

 private:
  // The files' checksums are added up, the list is written, the files are copied behind it, the whole is read back.
  enum class Stage : std::uint8_t { kSum, kList, kCopy, kBack, kEnded };
  Writer(std::filesystem::path data, std::filesystem::path file)
      : data_(std::move(data)), name_(std::move(file)) {}
  // The paths of all files, without their lengths and checksums yet.
  Result<void> AddFiles();
  // The file at `at_`, where it is not open yet.
  Result<void> OpenNext();
  // One for each stage but the last; each ends in the next one.
  Result<void> SumPiece();
  Result<void> WriteList();
  Result<void> CopyPiece();
  // The archive's end; then all of it is brought onto the stick and opened to be read back.
  Result<void> Finish();
  Result<void> Write(std::span<const std::uint8_t> bytes);
  // Gives the length of the piece, and adds it to the file's checksum.
  Result<std::size_t> ReadPiece(std::uint64_t most_bytes);

  // The data partition, and the backup's file.
  std::filesystem::path data_, name_;
  Contents contents_;
  Stage stage_ = Stage::kSum;
  // Of the files, that is being read.
  std::size_t at_ = 0;
  // That file, how much of it was read, and the checksum of so much. Null between two files.
  std::unique_ptr<Input> source_;
  std::uint64_t read_bytes_ = 0;
  std::vector<std::uint8_t> piece_;
  Sha256 sum_;
  UniqueFd out_;
  // Reads what was written; from the stage kBack on.
  std::optional<Reader> back_;
};

}  // namespace kaori::backup
