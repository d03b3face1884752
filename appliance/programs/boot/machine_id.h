// What tells a box from every other one: its number, machine-id(5), which is made at its first start and kept, and its name.
#pragma once

#include <filesystem>
#include <string>

#include "drivers/base/result.h"

namespace kaori::boot {

// What tells the PC itself from others, whatever disk is in it: 16 hexadecimal digits of the first serial number that its firmware says, in the
// folders class/dmi/id and firmware/devicetree/base of `sys`; empty where it says none. Many PCs of one maker may say the same.
std::string MachineMark(const std::filesystem::path& sys);

// The number in `file`: 32 lower-case hexadecimal digits, not all of them 0. A file that is missing or
// damaged is replaced by a new random number, so that two boxes that were made alike differ; and so is one that came with a copy of
// another PC's disk, by `machine` (MachineMark) and `file`.pc, which has it from before: a copied disk makes a box of its own. Does not
// wait until the kernel has gathered randomness: the number is no secret. A mark that cannot be written is written at a later start. Errors:
// those of writing `file`.
Result<std::string> KeptMachineId(const std::filesystem::path& file, const std::string& machine);

// What the box is called: as its settings say, or else "kaori-" and the first eight digits of its number, so that boxes
// that were set up alike have different names. "kaori" where it has no number either, since it keeps nothing. Pure.
std::string NameOfBox(const std::string& wanted, const std::string& machine_id);

}  // namespace kaori::boot
