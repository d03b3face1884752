// The trial of a pack: another process reads it, checks it and draws each of its scenes once. Whatever the
// pack does to that process, it is gone afterwards.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::shows {

// Shaders are compiled in it, and where the processor draws the show that plays leaves it next to nothing.
// Whoever does not want to wait turns the key back.
inline constexpr Duration kLongestTrial = std::chrono::minutes(30);

// Whom a trial is run as: a user who owns nothing. The process that asks for it has CAP_SETUID and
// CAP_SETGID.
struct TrialUser {
  uid_t user = 0;
  gid_t group = 0;
};

// Errors: invalid_argument, the system has no user of this name.
Result<TrialUser> FindUser(const std::string& name);

// Rights and groups of this process are its alone from now on: what it starts gets none of them. To be called
// before the first trial; where the process has no rights to give it does nothing. Errors: those of prctl(2)
// and setgroups(2).
Result<void> KeepRightsToOurselves();

// Makes the folder `trial` in `report`, where a trial keeps the shaders that it compiles: whoever it is run as makes files
// there, as in /tmp. No other program of the box may write to /run. A trial without it is slower.
void MakeTrialFolder(const std::filesystem::path& report);

// How a trial is run.
struct TrialTerms {
  Duration longest = kLongestTrial;
  // Asked ten times a second; null: always.
  std::function<bool()> wanted{};
  // The same: whether it may go on now. Meanwhile it is stopped, and that time does not count.
  std::function<bool()> may_work{};
  // Nobody: as this process.
  std::optional<TrialUser> user{};
};

// Runs `stage` --rehearse `pack` and waits for its end, as long as the terms say; then it is killed. Errors:
//   invalid_argument  it says that the show does not play: its own last line
//   timed_out, operation_canceled (not wanted any more), those of setresuid(2) and posix_spawn(3);
//   interrupted (a signal ended it)
Result<void> TryPack(const std::string& stage, const std::filesystem::path& pack,
                     const TrialTerms& terms = {});

}  // namespace kaori::shows
