#include "appliance/programs/stage/local_time.h"

#include "drivers/base/log.h"

namespace kaori::stage {
namespace {

constexpr std::time_t kEarliest = 1'735'689'600;  // 2025-01-01 00:00 UTC: no box is older.
constexpr Duration kAsks = std::chrono::seconds(1);

}  // namespace

// tm_wday counts from Sunday.
std::int32_t WeekMinute(std::time_t now) {
  std::tm local{};
  if (now < kEarliest || ::localtime_r(&now, &local) == nullptr) return performance::kNoWeekMinute;
  return (local.tm_wday + 6) % 7 * show::kDayMinutes + local.tm_hour * 60 + local.tm_min;
}

void LocalTime::Tell(const show::Show& show, const performance::LobbyNow& lobby, Time now,
                     performance::InputEvents& events) {
  if (!week_minute_ || !show.lobby || show.lobby->hours.empty() || now < asks_at_) return;
  asks_at_ = now + kAsks;
  const std::int32_t minute = week_minute_();
  const bool unknown = minute == performance::kNoWeekMinute;
  if (unknown && !said_unknown_)
    LogWarning("the time of day is not known: the clock is before 2025, and the lobby is open all day");
  if (!unknown && said_unknown_) Log("the time of day is known again: the lobby keeps its hours");
  said_unknown_ = unknown;
  if (minute != lobby.week_minute) events.week_minute = minute;
}

}  // namespace kaori::stage
