// The files of the page, carried inside the program.
#pragma once

#include <string_view>

namespace kaori::console {

struct PageFile {
  std::string_view path;  // "/" is the page itself.
  std::string_view content_type;
  std::string_view bytes;
};

// nullptr where nothing of that path is carried.
const PageFile* FindPageFile(std::string_view path);

}  // namespace kaori::console
