// Which root the kernel was told to believe, and which of the disk's two slots it started.
#pragma once

#include <string>
#include <string_view>

namespace kaori::boot {

// The hash in the dm-verity table of a kernel's command line (dm-mod.create=...): 64 digits; empty where
// there is none. Pure.
std::string RootHashOf(std::string_view command_line);

// The slot that a kernel's command line names (rauc.slot=A): "A" or "B"; empty where it names none, as on a
// disk that was written before both slots were filled. Pure.
std::string SlotOf(std::string_view command_line);

}  // namespace kaori::boot
