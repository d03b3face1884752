// What people do at a box in service that is no show: a line check, learn mode, and taking a show from the
// list of kaori-shows. One at a time.
#pragma once

#include <cstdint>
#include <optional>

#include "appliance/programs/stage/learner.h"
#include "appliance/programs/stage/line_checker.h"

namespace kaori::stage {

// One thread.
class ServiceModes {
 public:
  // Borrows the writers.
  ServiceModes(board::Writer<board::LineCheck>& line_check, board::Writer<board::Learn>& learn)
      : checker_(line_check), learner_(learn) {}

  // As LineChecker::Step and Learner::Step: while one of them runs the other does not begin. While the list
  // of shows is open neither begins, and the show gets no press, no dial and no call but PANIC and BLACKOUT;
  // sticks, lips and voice play on. Page Up, which opens it, is its own as long as kaori-shows runs.
  const board::Snapshot& Step(const LineChecker::Frame& frame, performance::InputEvents& events);

  // In the place of the show's, while the line check runs.
  std::optional<std::uint32_t> lamps(Time now) const {
    return checker_.running() ? std::optional(checker_.lamps(now)) : std::nullopt;
  }
  Learner& learner() { return learner_; }
  const Learner& learner() const { return learner_; }

 private:
  const board::Snapshot& WithholdForMenu(const LineChecker::Frame& frame, performance::InputEvents& events);

  LineChecker checker_;
  Learner learner_;
  board::Snapshot left_;  // Of the board, in a frame in which the list is open.
};

}  // namespace kaori::stage
