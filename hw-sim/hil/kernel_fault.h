// How the kernel tells in its log of a fault of its own.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace kaori::hil {

// How such a line begins: in kernel/panic.c, lib/bug.c, kernel/rcu/tree_stall.h and arch/x86/kernel/traps.c. A line of another
// severity, which tells of a device that is broken or of a setting, is no fault of the kernel.
inline constexpr std::array<std::string_view, 6> kKernelFaults{
    "BUG:", "WARNING:", "Oops", "general protection fault", "Kernel panic", "rcu: INFO"};

// What such a line has somewhere: in kernel/watchdog.c, behind "watchdog: BUG:", and kernel/hung_task.c, behind the name of the task.
inline constexpr std::array<std::string_view, 2> kKernelHangs{"soft lockup", "blocked for more than"};

// What controls of the bench write into the log, to see it found. It is one word, and no fault of anybody.
inline constexpr std::string_view kPlantedFault = "BUG:planted";

// `line` is without the time before it. Pure.
inline bool TellsOfKernelFault(std::string_view line) {
  return std::ranges::any_of(kKernelFaults,
                             [&](std::string_view begin) { return line.starts_with(begin); }) ||
         std::ranges::any_of(kKernelHangs,
                             [&](std::string_view part) { return line.find(part) != line.npos; });
}

}  // namespace kaori::hil
