// The number by which a box is told from every other one, machine-id(5): made at its first start, and kept.
#pragma once

#include <filesystem>
#include <string>

#include "drivers/base/result.h"

namespace kaori::boot {

// The number in `file`: 32 lower-case hexadecimal digits, not all of them 0. A file that is missing or
// damaged is replaced by a new random number, so that two boxes that were made alike differ. Does not wait
// until the kernel has gathered randomness: the number is no secret. Errors: those of writing the file.
Result<std::string> KeptMachineId(const std::filesystem::path& file);

}  // namespace kaori::boot
