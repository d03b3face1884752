// The one reader for files that a person names: regular files only, bounded in size and in nesting.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "drivers/base/result.h"

namespace kaori {

// More levels than any file of this project has, and few enough for every parser:
// toml++ and nlohmann's library call themselves once a level, and 32 of their frames
// fit into the smallest stack that we give a thread.
inline constexpr int kMostLevels = 32;

// What a caller allows a file to be. The defaults bound the memory that a wrong name can cost.
struct ReadLimits {
  std::size_t most_bytes = std::size_t{16} << 20U;  // Far more than anybody writes by hand.
  // Levels of brackets, braces and dotted keys of TOML or JSON; 0: the text is neither and is not looked at.
  // Parsers and destructors of trees call themselves once a level, so that the stack is the real limit.
  int most_levels = 0;
};

// Reads a whole file; blocks for the disk, never for a peer: it is opened with O_NONBLOCK, and its kind
// and its size are asked before a byte is read or allocated. Files of /proc and /sys, whose size is 0,
// are read as far as they go. A file that grows meanwhile is read to its new end. The bytes are not
// checked to be text. Any thread. Errors, in one line that names the file:
//   those of open(2) and read(2): no_such_file_or_directory, permission_denied ...
//   is_a_directory     a folder
//   invalid_argument   a pipe, a socket or a device (kInput)
//   file_too_large     more than `most_bytes` (kInput)
//   bad_message        more than `most_levels`; the line is named (kInput)
Result<std::string> ReadFile(const std::filesystem::path& file, const ReadLimits& limits = {});

// The first `most_bytes` of a file, or all of it where it is shorter; otherwise as ReadFile, without
// file_too_large.
Result<std::string> ReadBeginning(const std::filesystem::path& file, std::size_t most_bytes);

// Reads a whole file and keeps nothing of it: whether its disk gives all of it is known then, before it is mapped, where
// what cannot be read ends the process. Blocks for the disk. Errors: those of open(2) and read(2); is_a_directory,
// invalid_argument, as ReadFile.
Result<void> ReadThrough(const std::filesystem::path& file);

// As ReadFile does, for a text that is there already. `name` is what the error says
// of it. Where the text is no valid TOML or JSON the answer may be wrong; the parser
// then refuses the text in any case. Errors: bad_message.
Result<void> CheckLevels(std::string_view text, int most_levels, const std::string& name);

}  // namespace kaori
