// The support file on a stick.
#pragma once

#include <ctime>
#include <filesystem>
#include <string>

#include "appliance/programs/shows/messages.h"
#include "drivers/base/result.h"

namespace kaori::shows {

// "kaori-1a2b3c4d-20261123-221005.txt", by the box's name and its clock.
std::string SupportFileName(const std::string& box, std::time_t wall);

// Writes a new file at the top of the stick, which can be written, and reads it back from there. Returns once
// it is on the stick; nothing else of that is touched, and where it fails the file is removed again. Blocks
// for the stick. Errors: those of open(2), write(2), fsync(2) and read(2): no_space_on_device, file_exists
// ...; bad_message: what was read back is not what was written.
Result<void> WriteSupportFile(const std::filesystem::path& stick, const std::string& name,
                              const std::string& text);

// What an error of writing onto a stick means to a person.
Message SupportMessageOf(const Error& error);

}  // namespace kaori::shows
