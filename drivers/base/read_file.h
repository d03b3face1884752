// The one reader for files that a person names: regular files only, bounded in size and in nesting.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

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

// A regular file that is open for reading.
struct RegularFile {
  UniqueFd fd;
  std::uintmax_t bytes = 0;  // As long as it said it is when it was opened; 0 of those of /proc and /sys.
};

// Whether the last part of a name may be a symbolic link. It may not on a stick, whose maker is unknown: a link there
// would name a file of the box.
enum class Links : std::uint8_t { kFollow, kRefuse };

// Opens a file that somebody named, for whoever reads it in pieces of his own. Waits for nobody: it is opened with
// O_NONBLOCK, and its kind is asked of the descriptor, so that nothing changes between look and use. `attempt` says what
// was tried and names the file. Any thread; the descriptor is the caller's. Errors: those of open(2) and fstat(2);
// is_a_directory; invalid_argument (kInput) for a pipe, a socket or a device; too_many_symbolic_link_levels for a link
// that is refused.
Result<RegularFile> OpenRegular(const std::filesystem::path& file, const std::string& attempt,
                                Links links = Links::kFollow);

// The same of a file that another one opened and handed over. Errors: those of fstat(2); is_a_directory and
// invalid_argument as above.
Result<RegularFile> RequireRegular(UniqueFd fd, const std::string& attempt);

// Whether that is why it was refused: what has the name is no file, and not that it could not be opened.
bool IsNoFile(const Error& error);

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
