// All that a PC wrote while it was updated, over several starts: for whoever cuts its power at any of these writes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hw-sim/hil/updated_pc.h"
#include "hw-sim/hil/write_log.h"

namespace kaori::hil {

// Files in a folder of its own below the bench's, which go with it unless they are kept. One thread.
class UpdateHistory {
 public:
  // The disk of a PC that is off, from which all begins. Errors: io_error.
  static Result<UpdateHistory> Begin(Scene& scene, const UpdatedPc& pc);
  // The one that was kept, as if nothing had been cut yet. Nothing where none was. Errors: as Begin and WriteLog::Read.
  static Result<std::optional<UpdateHistory>> Kept(Scene& scene);
  // Its files stay, for Kept, until another one begins: bringing an update in once more would take many times as long as cutting it.
  void Keep() { is_kept_ = true; }
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
  // The disk from which all begins, which no cut changes.
  std::string Begun() const { return folder_ + "/begun.disk"; }
  // Makes Disk() as all began. Errors: io_error.
  Result<void> Rewind();
  // Takes the log that lies at its Name as the next start's. Errors: as WriteLog::Read.
  Result<void> ReadNext();

  // Empty: moved away.
  std::string folder_;
  bool is_kept_ = false;
  std::vector<WriteLog> starts_;
  // How much of it Disk() has.
  std::size_t replayed_ = 0;
};

}  // namespace kaori::hil
