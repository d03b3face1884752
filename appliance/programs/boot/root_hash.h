// Which root the kernel was told to believe, and which of the disk's two slots it started.
#pragma once

#include <string>
#include <string_view>

namespace kaori::boot {

// The hash in the dm-verity table of a kernel's command line (dm-mod.create=...): 64 digits; empty where
// there is none. Pure.
std::string RootHashOf(std::string_view command_line);

// Whether the note of an update that waits (appliance/core/update/pending.h) is of this slot, "A" or "B": this start is a try of it then.
// Any text may be given for both. Pure.
bool IsTried(std::string_view note, std::string_view slot);

// The slot that a kernel's command line names (rauc.slot=A): "A" or "B"; empty where it names none, as on a
// disk that was written before both slots were filled. Pure.
std::string SlotOf(std::string_view command_line);

}  // namespace kaori::boot
