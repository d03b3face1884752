// The time of day for the lobby's opening hours, from a wall clock that may be wrong or be set while it runs.
#pragma once

#include <cstdint>
#include <ctime>
#include <functional>

#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/lobby_state.h"
#include "appliance/core/show/show.h"
#include "drivers/base/clock.h"

namespace kaori::stage {

// Minutes since Monday 00:00 in local time; performance::kNoWeekMinute for a time before 2025, which is that
// of a box whose clock has lost its battery.
std::int32_t WeekMinute(std::time_t now);

// Tells the performance of each new minute. One thread.
class LocalTime {
 public:
  // What gives the minute of the week, as WeekMinute has it; asked once a second, on the frame path, so that
  // it must neither wait nor allocate. Without one the time of day is not known.
  void Set(std::function<std::int32_t()> week_minute) { week_minute_ = std::move(week_minute); }

  // Adds the minute to the frame's events where it is another one than `lobby` was told last. Says nothing to
  // a show without opening hours. A line in the log when the clock cannot be believed, and when it can again.
  void Tell(const show::Show& show, const performance::LobbyNow& lobby, Time now,
            performance::InputEvents& events);

 private:
  std::function<std::int32_t()> week_minute_;
  Time asks_at_{};
  bool said_unknown_ = false;
};

}  // namespace kaori::stage
