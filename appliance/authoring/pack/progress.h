// Says on standard error how far a long work has come: one line that changes on a terminal, a line a step in
// a log.
#pragma once

#include <string>
#include <string_view>

#include "drivers/base/clock.h"

namespace kaori::authoring {

// One thread. The line goes away with the object, so that what is said next starts at the left.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  // "[  1.2 s] painting the faces".
  void Step(std::string_view what);

  // A line that stays.
  void Note(std::string_view what);

  double seconds() const { return Seconds(clock_.now() - begun_); }

 private:
  SteadyClock clock_;
  Time begun_;
  bool on_terminal_;
  bool shown_ = false;
};

}  // namespace kaori::authoring
