// Logs that a source of samples fell silent and that it delivers again, without filling the log where it
// flickers.
#pragma once

#include <string>

#include "drivers/base/clock.h"

namespace kaori {

// Logs at most one silence a minute, with the number of those it left out, and the end of each silence
// that it logged. A camera on a loose cable falls silent many times a minute, and its lines would push
// all others out of the journal. Asks no clock: time is an argument. One thread.
class SilenceLog {
 public:
  // The words of its lines: "lip camera", "the lips are stale".
  SilenceLog(std::string source, std::string consequence)
      : source_(std::move(source)), consequence_(std::move(consequence)) {}

  // Called once when the source has been silent for `length` (logged in whole
  // milliseconds, with severity kWarning), and when it delivers again.
  void Silent(Duration length, Time now);
  void Speaks();

  // Called when the loss was logged by another line: that it delivers again is logged in any case.
  void Lost() { said_ = true; }

 private:
  std::string source_, consequence_;
  // No silence is logged before this time.
  Time quiet_until_{};
  // How many silences were left out since the last line.
  int unsaid_ = 0;
  // The silence is in the log, and so will be its end. True at the
  // beginning, so that the first sample is logged too.
  bool said_ = true;
};

}  // namespace kaori
