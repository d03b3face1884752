// How the kernel begins a line of its log that tells of a fault of its own.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace kaori::hil {

// In kernel/panic.c, lib/bug.c and arch/x86/kernel/traps.c. A line of another severity, which tells of a device that is
// broken or of a setting, is no fault of the kernel: the check `kernel` looks at those by their number.
inline constexpr std::array<std::string_view, 5> kKernelFaults{
    "BUG:", "WARNING:", "Oops:", "general protection fault", "Kernel panic"};

// `line` is without the time before it. Pure.
inline bool TellsOfKernelFault(std::string_view line) {
  return std::ranges::any_of(kKernelFaults, [&](std::string_view begin) { return line.starts_with(begin); });
}

}  // namespace kaori::hil
