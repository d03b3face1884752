// Says on standard error how far a long work has come: one line that changes on a terminal, a line a step in
// a log.
#pragma once

#include <string>
#include <string_view>

#include "drivers/base/clock.h"

namespace kaori::authoring {

// For one thread. The line goes away with the object, so that what is said next starts at the left; begin to
// print results only after that.
class ProgressLine {
 public:
  // The seconds count from here.
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  // Replaces the line on a terminal, adds one to a log: "[  1.2 s] painting the faces".
  void Step(std::string_view what);

  // A line that stays; the next Step stands below it.
  void Note(std::string_view what);

  // Since the object was made, of the monotonic clock.
  double seconds() const { return Seconds(clock_.now() - begun_); }

 private:
  SteadyClock clock_;
  Time begun_;
  // Standard error is one.
  bool on_terminal_;
  // A step stands on the line.
  bool shown_ = false;
};

}  // namespace kaori::authoring
