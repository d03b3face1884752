// A file of a web page that is compiled into the program by embed.cmake.
#pragma once

#include <string_view>

namespace kaori::web {

// One file of a page. Everything lives as long as the program.
struct PageFile {
  std::string_view path;  // "/" is the page itself.
  // The Content-Type header with which it is served.
  std::string_view content_type;
  // Part of the program: lives as long as it does.
  std::string_view bytes;
};

}  // namespace kaori::web
