// The show pack: one file, verified when it is opened, copied out of the mapping into a Show.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "appliance/show/show.h"
#include "drivers/base/result.h"

namespace kaori::show {

inline constexpr std::uint32_t kPackVersion = 1;

// Reads and checks a pack; blocks for the file. A damaged, truncated or foreign file, one of another version,
// and a cast that CheckCast faults are refused with one line that names the file and the reason. Errors:
//   as open(2)         the file cannot be read
//   invalid_argument   it is no sound pack of this version
Result<Show> LoadPack(const std::filesystem::path& file);

// The bytes of a pack. The show must be sound: LoadPack of the bytes gives the same show.
std::vector<std::uint8_t> EncodePack(const Show& show);

// Writes the file whole or not at all (temporary file, fsync, rename). Errors: as open(2) and write(2).
Result<void> SavePack(const Show& show, const std::filesystem::path& file);

}  // namespace kaori::show
