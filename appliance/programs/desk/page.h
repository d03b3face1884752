// The files of the page, carried inside the program.
#pragma once

#include <string_view>

#include "drivers/web/page_file.h"

namespace kaori::desk {

// nullptr where nothing of that path is carried.
const web::PageFile* FindPageFile(std::string_view path);

}  // namespace kaori::desk
