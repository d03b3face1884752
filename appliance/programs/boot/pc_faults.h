// What the PC itself lacks or forgot, as the first program finds it: its clock and its graphics card.
#pragma once

#include <filesystem>
#include <vector>

#include "appliance/programs/boot/report.h"

namespace kaori::boot {

// One sentence for each fault, for the box's status. A clock that stands before `of_image` was made, a file of the image, is
// set as MendedClock says; the PC's own clock is left to a person, since whether its battery keeps anything is not known.
// Graphics are asked last of all drivers: these have had the files that they wanted, or not. Blocks for the disk on which
// `kept` lies. Needs /sys.
std::vector<Fault> PcFaults(const std::filesystem::path& of_image, const std::filesystem::path& kept);

}  // namespace kaori::boot
