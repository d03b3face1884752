// What people do at a box in service that is no show: a line check, and learn mode. One at a time.
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

  // As LineChecker::Step and Learner::Step: while one of them runs the other does not begin.
  const board::Snapshot& Step(const LineChecker::Frame& frame, performance::InputEvents& events);

  // In the place of the show's, while the line check runs.
  std::optional<std::uint32_t> lamps(Time now) const {
    return checker_.running() ? std::optional(checker_.lamps(now)) : std::nullopt;
  }
  Learner& learner() { return learner_; }
  const Learner& learner() const { return learner_; }

 private:
  LineChecker checker_;
  Learner learner_;
};

}  // namespace kaori::stage
