// The trial of a pack: another process reads it, checks it and draws each of its scenes once. Whatever the
// pack does to that process, it is gone afterwards.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::shows {

// Shaders are compiled in it, and where the processor draws the show that plays leaves it next to nothing.
// Whoever does not want to wait turns the key back.
inline constexpr Duration kLongestTrial = std::chrono::minutes(30);

// The right to mount is this process's alone from now on: what it starts gets neither that nor any other. To
// be called before the first trial; where the process has no rights to give it does nothing. Errors: those of
// prctl(2).
Result<void> KeepRightsToOurselves();

// Runs `stage` --rehearse `pack` and waits for its end, `longest` at most, and while `wanted`, which is asked
// ten times a second, says so (null: always); then it is killed. Errors:
//   invalid_argument  it says that the show does not play: its own last line
//   timed_out, operation_canceled (not wanted any more), those of posix_spawn(3); interrupted (a signal ended it)
Result<void> TryPack(const std::string& stage, const std::filesystem::path& pack,
                     Duration longest = kLongestTrial, const std::function<bool()>& wanted = {});

}  // namespace kaori::shows
