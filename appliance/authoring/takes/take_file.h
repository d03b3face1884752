// The files of takes: takes/NAME.toml in a show's folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "appliance/authoring/takes/take.h"
#include "appliance/core/toml/section.h"
#include "drivers/base/result.h"

namespace kaori::authoring {

// Where a show's folder has its takes.
std::filesystem::path FileOfTake(const std::filesystem::path& folder, std::string_view name);

// Reads a take out of its file's table; what is wrong with it becomes a fault of `faults`, which are those of
// the file. What the file names elsewhere (key, sound, expressions) is not looked up. With faults the take is
// filled in part.
Take ReadTake(toml::Section file, toml::Faults& faults, std::string name);

// "under", "over" or "add" under `layer`, of a take or of a motion; add where there is none. Another word is a fault.
show::MotionLayer ReadLayer(toml::Section& section);

// Blocks for the disk. Errors: those of ReadToml; kInput: all faults of the file, one a line.
Result<Take> LoadTake(const std::filesystem::path& folder, const std::string& name);

// As ReadTake reads it, every number to the bit.
std::string TextOf(const Take& take);

// Whole or not at all, in a folder takes/ that is made where it is not there. Errors: those of
// WriteWholeFile, and of making the folder; kInput: the faults that ReadTake finds in it. Then nothing is
// written.
Result<void> SaveTake(const std::filesystem::path& folder, const Take& take);

// One line for people: "8.00 s of head_yaw, head_pitch; from 1.00 to 6.00 s, 1.5 times as long, in a loop of
// 7.00 s".
std::string Described(const Take& take);

}  // namespace kaori::authoring
