#include "appliance/programs/stage/call_log.h"

#include <utility>

#include "drivers/base/log.h"

namespace kaori::stage {
namespace {

constexpr Duration kLockQuiet = std::chrono::seconds(10);

void TellOfTheSensor(const performance::State& before, const performance::State& after,
                     const show::Show& show) {
  const bool stuck = performance::IsSensorStuck(after.lobby, show);
  if (stuck == performance::IsSensorStuck(before.lobby, show)) return;
  if (stuck)
    LogWarning(
        "the presence sensor has said for {:.0f} s without a break that somebody is there: the lobby "
        "takes it for stuck until it says the contrary",
        show.lobby->stuck_s);
  else
    Log("the presence sensor says that nobody is there: the lobby follows it again");
}

}  // namespace

void CallLog::Tell(const performance::State& before, const performance::State& after, const show::Show& show,
                   Time now) {
  TellOfTheSensor(before, after, show);
  if (const std::uint32_t refused = after.calls_refused - before.calls_refused; refused != 0)
    LogWarning("{} calls were refused: the show has no such cue, level or role", refused);
  if (const std::uint32_t lost = after.calls_lost - before.calls_lost; lost != 0)
    LogWarning("{} calls are lost: more came between two frames than the board keeps", lost);
  if (after.locked > before.locked)
    Log("the show is locked: only those who play are heard, until the service key is on");
  if (after.locked < before.locked) Log("the show is unlocked by the service key");
  if (after.locks_denied != before.locks_denied) LogWarning("the show is not locked: the service key is on");
  untold_ += after.locked_out - before.locked_out;
  if (untold_ == 0 || now < quiet_until_) return;
  quiet_until_ = now + kLockQuiet;
  LogWarning("{} presses or calls were refused: the show is locked", std::exchange(untold_, 0));
}

}  // namespace kaori::stage
