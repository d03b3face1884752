// All that a PC wrote while it was updated, over several starts: for whoever cuts its power at any of these writes.
#pragma once

#include <string>
#include <vector>

#include "hw-sim/hil/updated_pc.h"
#include "hw-sim/hil/write_log.h"

namespace kaori::hil {

// Files in a folder of its own below the bench's, which go with it. One thread.
class UpdateHistory {
 public:
  // The disk of a PC that is off, from which all begins. Errors: io_error.
  static Result<UpdateHistory> Begin(Scene& scene, const UpdatedPc& pc);
  UpdateHistory(UpdateHistory&& other) noexcept;
  UpdateHistory& operator=(UpdateHistory&&) = delete;
  ~UpdateHistory();

  // What the PC wrote in the start that has ended, which was noted; and what its firmware keeps since. The log is taken from the PC.
  // Errors: as WriteLog::Read; io_error.
  Result<void> Add(const UpdatedPc& pc);

  // Each start's writes, in order.
  const std::vector<WriteLog>& starts() const { return starts_; }
  // The disk as it stands: as all began, until the first CutAfter.
  std::string Disk() const { return folder_ + "/cut.disk"; }
  // Of all starts, in order; where their content lies is of no use without the start.
  std::vector<LoggedWrite> Writes() const;
  // How many there are.
  std::size_t entries() const;
  // The first entry that writes into this span, counted over all starts; entries() where none does. Pure.
  std::size_t FirstInto(const DiskSpan& span) const;
  // Sectors of 512 bytes that were written outside of all these spans. Pure.
  std::uint64_t SectorsOutside(const std::vector<DiskSpan>& spans) const;

  // Gives the PC, which is off, the disk as it stood when the power went after so many entries. Variables are those of
  // a new PC for the first start, and for later ones what the firmware kept after them: a try that has begun was
  // struck from them by its first moment. Calls come with numbers that do not fall, since the disk is made by going on.
  // Errors: io_error; invalid_argument, the number falls.
  Result<void> CutAfter(std::size_t entries, const UpdatedPc& pc);

 private:
  explicit UpdateHistory(std::string folder) : folder_(std::move(folder)) {}
  std::string Name(std::size_t start, const char* what) const;

  // Empty: moved away.
  std::string folder_;
  std::vector<WriteLog> starts_;
  // How much of it Disk() has.
  std::size_t replayed_ = 0;
};

}  // namespace kaori::hil
