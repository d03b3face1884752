// Makes the incidents of a running order happen to a rehearsal, by what really would: bytes on a link, files
// on a disk.
#pragma once

#include <filesystem>
#include <string>

#include "appliance/programs/stage/show_log.h"
#include "drivers/base/result.h"
#include "hw-sim/evening/running_order.h"
#include "hw-sim/monitor/stage_caller.h"
#include "hw-sim/rehearsal/rehearsal.h"

namespace kaori::sim {

// One thread, that of the rehearsal. Borrows all three, and leaves the disk as it found it.
class Incidents {
 public:
  Incidents(Rehearsal& rehearsal, const Clock& clock, stage::ShowLog& log)
      : rehearsal_(rehearsal), log_(log), page_(rehearsal.board().path(), clock) {}
  Incidents(const Incidents&) = delete;
  Incidents& operator=(const Incidents&) = delete;
  ~Incidents();

  // The page comes, which stays for the evening: its board is open from then on. Errors: those of
  // StageCaller.
  Result<void> Begin() { return Call(kNothing, 1); }

  // Errors: those of the file system, of the links and of the programs that start; an incident that cannot be
  // made is none that was stood.
  Result<void> Make(const Incident& incident);

 private:
  // A call that changes nothing: to let go of what nobody has.
  static constexpr const char* kNothing = "letgo 16";

  Result<void> Call(const std::string& words, int times);
  Result<void> SpoilBoard(Incident::Kind how);
  // /dev/full stands where the log is written: the kernel's own answer is that there is no space left.
  Result<void> FillDisk();
  Result<void> FreeDisk();

  Rehearsal& rehearsal_;
  stage::ShowLog& log_;
  StageCaller page_;
  // The log's file while its disk is full; empty: it is not.
  std::filesystem::path full_;
};

}  // namespace kaori::sim
