// The kernel's log, read from /dev/kmsg for what tells of a fault of the kernel itself.
#pragma once

#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::agent {

// One thread. Nothing waits.
class KernelLog {
 public:
  enum class From { kOldestRecord, kNow };

  // Errors: those of opening /dev/kmsg.
  static Result<KernelLog> Open(From from);

  // The texts of the records since the last call that tell of a fault, in their order. Of a log that was overrun the records that are
  // left.
  std::vector<std::string> NewFaults();

 private:
  explicit KernelLog(UniqueFd log) : log_(std::move(log)) {}
  UniqueFd log_;
};

// The text of a record, as /dev/kmsg gives them, that tells of a fault of the kernel itself; empty where it
// does not. Pure.
std::string FaultIn(const std::string& record);

}  // namespace kaori::agent
