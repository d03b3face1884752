// The files of the page, carried inside the program.
#pragma once

#include <string_view>

#include "drivers/web/page_file.h"

namespace kaori::desk {

// Returns the file of this path, or null where there is none. The files are made into the program when it is
// built, so that the desk reads nothing from the disk for a visitor; the pointer is valid for ever.
const web::PageFile* FindPageFile(std::string_view path);

}  // namespace kaori::desk
