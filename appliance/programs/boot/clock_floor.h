// A PC that forgot the time, as one does whose battery is flat.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace kaori::boot {

// Of the clock of days and years (CLOCK_REALTIME), in whole seconds.
using Date = std::chrono::sys_seconds;

// The date at which the clock has to stand at least; nothing where it may be right. It is wrong where it stands before
// `made`, the date that all files of the image bear: then the newest date of a file below `kept` is the last that the box
// knew, which is `made` at least. A clock that is right is never moved by what lies there. Blocks for the disk.
std::optional<Date> MendedClock(Date now, Date made, const std::filesystem::path& kept);

// As in "2026-11-25 19:30 UTC".
std::string Shown(Date date);

}  // namespace kaori::boot
