// When the box makes its show reports.
#pragma once

#include <optional>

#include "drivers/base/clock.h"

namespace kaori::report {

// What tells that an evening may be over.
struct EveningSigns {
  bool service_key = false;  // Somebody works at the box: it is packed, or backed up.
  bool list_over = false;    // The last cue has been played.
};

// Once after the start, for the evening before, whose plug was pulled; when the last cue has been played; and when the
// service key is turned on: at once, and once more when the log has what was played until then. Pure but for its memory.
class ReportTimes {
 public:
  // The face has the processors first: from this start on for so long no report is made.
  static constexpr Duration kAfterStart = std::chrono::seconds(60);
  // A log has on the disk what was played 30 s before (showlog::kChunkTime), and some seconds for the disk.
  static constexpr Duration kLogIsWritten = std::chrono::seconds(40);

  explicit ReportTimes(Time started) : due_(started + kAfterStart) {}

  // Whether reports are to be made at `now`, which rises.
  bool IsDue(Time now, const EveningSigns& signs);

 private:
  std::optional<Time> due_, due_again_;
  EveningSigns before_;
};

}  // namespace kaori::report
