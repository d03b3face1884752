// Every fault of a show's authoring files, all of them at once.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kaori::authoring {

// What was found in a folder, one line each: file, line where there is one, item, reason.
struct FolderCheck {
  // With any of them there is no pack; without, AuthorShow will succeed.
  std::vector<std::string> faults;
  // What can be packed and should not be shown: expressions that fold the skin of a face. Looked for where
  // there is no fault.
  std::vector<std::string> flaws;
};

// Reads faces, looks, expressions and script of `folder`, however much of it is wrong, and sculpts the faces
// where that can be done; paints nothing and writes nothing. Blocks for about two seconds, on all processors.
// What depends on a file that cannot be read is left out, so that one slip does not make a hundred lines. A
// folder that is not there is one fault.
FolderCheck CheckFolder(const std::filesystem::path& folder);

// One a line, without a newline at the end: the text of an Error.
std::string JoinFaults(const std::vector<std::string>& faults);

}  // namespace kaori::authoring
