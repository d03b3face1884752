#include "appliance/programs/report/report_times.h"

#include <utility>

namespace kaori::report {

// A sign counts when it comes, not for as long as it stands.
bool ReportTimes::IsDue(Time now, const EveningSigns& signs) {
  const EveningSigns before = std::exchange(before_, signs);
  if (signs.service_key && !before.service_key) {
    due_ = now;
    due_again_ = now + kLogIsWritten;
  }
  if (signs.list_over && !before.list_over) due_again_ = now + kLogIsWritten;
  bool due = false;
  for (std::optional<Time>* time : {&due_, &due_again_})
    if (*time && now >= **time) {
      due = true;
      time->reset();
    }
  return due;
}

}  // namespace kaori::report
