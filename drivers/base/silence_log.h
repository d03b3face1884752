// Says in the log that a source fell silent and that it speaks again, however often it does.
#pragma once

#include <string>

#include "drivers/base/clock.h"

namespace kaori {

// At most one silence in a minute is said, with the number of those that were not; its end is said as well.
// Pure but for the log: time is in the arguments.
class SilenceLog {
 public:
  // Of the log's lines: "lip camera", "the lips are stale".
  SilenceLog(std::string source, std::string consequence)
      : source_(std::move(source)), consequence_(std::move(consequence)) {}

  void Silent(Duration length, Time now);
  void Speaks();

  // It was lost in a way that the log told: that it speaks again is said in any case.
  void Lost() { said_ = true; }

 private:
  std::string source_, consequence_;
  Time quiet_until_{};
  int unsaid_ = 0;
  bool said_ = true;  // That it does not speak.
};

}  // namespace kaori
