// Puts #include "file" lines of a shader in place, with #line marks so that errors can be traced back.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/base/result.h"
#include "render/gl/program.h"

namespace kaori::gl {

// A text without #include lines.
struct WholeText {
  std::string text;
  // File number n of the #line marks.
  std::vector<std::string_view> files;
};

// The text of a shader with its #version line, default precisions, the source's defines, and all #include
// lines put in place. Each file is put in once, at its first #include. Errors: no_such_file_or_directory
// (names the file).
Result<WholeText> Assemble(const ProgramSource& source, std::string_view file);

// Replaces a driver's "n:line" at the start of each line of its log by "file:line", and joins the lines with
// "; ". Understands Mesa's "0:12(3): error" and the common "ERROR: 0:12:".
std::string NameFiles(std::string_view log, std::span<const std::string_view> files);

}  // namespace kaori::gl
