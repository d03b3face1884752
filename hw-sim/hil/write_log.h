// What a machine wrote to one of its disks, in order, as QEMU's blklogwrites keeps it: for whoever cuts its power at any of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::hil {

// One write, or a flush of all that came before.
struct LoggedWrite {
  // Where on the disk; 0 of a flush.
  std::uint64_t at_bytes = 0;
  // 0: a flush.
  std::uint64_t bytes = 0;
  // Where its content begins in the log's file.
  std::uint64_t content_at = 0;
};

// A part of a disk.
struct DiskSpan {
  std::uint64_t at_bytes = 0;
  std::uint64_t bytes = 0;
  // Whether the write lies in it wholly. Pure.
  bool Holds(const LoggedWrite& write) const;
  // Whether they have a byte in common. Pure.
  bool Meets(const LoggedWrite& write) const;
};

// What is wrong with how a machine decided something by one write into the sector `deciding`, and nothing where all is right: what it
// wrote into the spans `before` (but into that sector) was flushed by then, no more of it followed, and the sector was written once. Pure.
std::string DecisionFault(const std::vector<LoggedWrite>& entries, const std::vector<DiskSpan>& before,
                          const DiskSpan& deciding);

// Entries of one start of a machine. Its content stays in the file, which must live as long.
class WriteLog {
 public:
  // Reads all entries, those behind the last flush too, which the log's head does not count. What ends in the middle
  // ends the log, and one that never flushed has no head: the machine was killed there. Errors: those of the file; invalid_argument (no such log).
  static Result<WriteLog> Read(const std::string& file);

  const std::vector<LoggedWrite>& entries() const { return entries_; }
  // Whether anything was written wholly within the span. Pure.
  bool WritesInto(const DiskSpan& span) const;
  // Sectors of 512 bytes of the writes that lie wholly in none of the spans. Pure.
  std::uint64_t SectorsOutside(const std::vector<DiskSpan>& spans) const;

  // What one of the writes wrote. Errors: io_error.
  Result<std::string> Content(const LoggedWrite& write) const;

  // Puts the writes [from, until) onto a disk's file. Errors: io_error.
  Result<void> Replay(std::size_t from, std::size_t until, const std::string& disk) const;

 private:
  WriteLog(std::string file, std::vector<LoggedWrite> entries)
      : file_(std::move(file)), entries_(std::move(entries)) {}
  // One of the writes. Errors: as Replay.
  Result<void> Put(const LoggedWrite& write, const std::string& disk) const;

  std::string file_;
  std::vector<LoggedWrite> entries_;
};

}  // namespace kaori::hil
