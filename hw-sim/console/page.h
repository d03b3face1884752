// The files of the page, carried inside the program.
#pragma once

#include <string_view>

#include "drivers/web/page_file.h"

namespace kaori::console {

// The file of the page with this path, as it was compiled in; nullptr where nothing of that path
// is carried. Lives as long as the program.
const web::PageFile* FindPageFile(std::string_view path);

}  // namespace kaori::console
