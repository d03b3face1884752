// The files of the page, carried inside the program.
#pragma once

#include <string_view>

#include "drivers/web/page_file.h"

namespace kaori::desk {

// Returns the file of this path, or null where there is none.
const web::PageFile* FindPageFile(std::string_view path);

}  // namespace kaori::desk
