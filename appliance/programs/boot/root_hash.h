// Which root the kernel was told to believe.
#pragma once

#include <string>
#include <string_view>

namespace kaori::boot {

// The hash in the dm-verity table of a kernel's command line (dm-mod.create=...): 64 digits; empty where
// there is none. Pure.
std::string RootHashOf(std::string_view command_line);

}  // namespace kaori::boot
