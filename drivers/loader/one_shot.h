// The firmware's variable by which systemd-boot starts another entry than its default, once.
#pragma once

#include <filesystem>
#include <string_view>

#include "drivers/base/result.h"

namespace kaori::loader {

// As the kernel mounts it.
inline constexpr const char* kVariables = "/sys/firmware/efi/efivars";

// The firmware keeps it in its own memory, over a power cut as well, until the loader has read it: so a try that was asked for
// may be made hours later, and is one all the same.
//
// Writes LoaderEntryOneShot with an entry's name, "kaori-b.efi", and reads it back; the loader removes it as
// it reads it. `folder` is that of efivarfs. Blocks for the firmware. Errors:
//   not_supported      there are no variables, or what was read back is not what was written
//   permission_denied  this program may not write them
Result<void> WriteOneShot(const std::filesystem::path& folder, std::string_view entry);

}  // namespace kaori::loader
