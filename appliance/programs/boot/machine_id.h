// What tells a box from every other one: its number, machine-id(5), which is made at its first start and kept, and its name.
#pragma once

#include <filesystem>
#include <string>

#include "drivers/base/result.h"

namespace kaori::boot {

// The number in `file`: 32 lower-case hexadecimal digits, not all of them 0. A file that is missing or
// damaged is replaced by a new random number, so that two boxes that were made alike differ. Does not wait
// until the kernel has gathered randomness: the number is no secret. Errors: those of writing the file.
Result<std::string> KeptMachineId(const std::filesystem::path& file);

// What the box is called: as its settings say, or else "kaori-" and the first eight digits of its number, so that boxes
// that were set up alike have different names. "kaori" where it has no number either, since it keeps nothing. Pure.
std::string NameOfBox(const std::string& wanted, const std::string& machine_id);

}  // namespace kaori::boot
