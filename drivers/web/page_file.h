// A file of a page, carried inside the program: see embed.cmake.
#pragma once

#include <string_view>

namespace kaori::web {

struct PageFile {
  std::string_view path;  // "/" is the page itself.
  std::string_view content_type;
  std::string_view bytes;
};

}  // namespace kaori::web
