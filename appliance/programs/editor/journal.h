// The journal: every change of a session, one after the other in a file, so that a crash loses next to
// nothing. The file begins with eight bytes of magic and the fingerprint of the control points; record.h has
// the records.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "appliance/programs/editor/record.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::editor {

// Any one thread. Movable; the file stays locked for as long as the object lives, on the whole machine.
class Journal {
 public:
  struct Opened;

  // Opens the file, or makes it, and reads what an earlier session wrote; blocks for the disk. A record that
  // was torn is cut off. A journal of other control points (`fingerprint`), or a file that is none, is
  // renamed to FILE.NUMBER, and is read again when its control points are back. Errors:
  //   device_or_resource_busy  another program has it open
  //   as open(2), read(2) and write(2)
  static Result<Opened> Open(const std::filesystem::path& file, std::uint64_t fingerprint);

  // Appends and waits until it is on the disk; nothing of it is there where it fails. Errors: as write(2) and
  // fdatasync(2): no_space_on_device ...
  Result<void> Append(std::span<const std::uint8_t> bytes);

  // Forgets all records, on the disk too. Errors: as ftruncate(2).
  Result<void> Clear();

 private:
  // Cuts the file off behind the last whole record. Errors: as ftruncate(2).
  Result<void> CutOff();

  Journal(UniqueFd fd, std::filesystem::path file, std::uint64_t fingerprint)
      : fd_(std::move(fd)), file_(std::move(file)), fingerprint_(fingerprint) {}

  UniqueFd fd_;
  std::filesystem::path file_;
  // Of the control points; it goes into the head of an empty file.
  std::uint64_t fingerprint_ = 0;
  std::uint64_t end_ = 0;  // Of the last whole record; 0: not even the head stands there.
};

// What Open found.
struct Journal::Opened {
  Journal journal;
  std::vector<Record> records;
  // Bytes behind the last whole record, which are left out.
  std::size_t torn_bytes = 0;
  // A journal of other control points was renamed.
  bool put_aside = false;
};

}  // namespace kaori::editor
