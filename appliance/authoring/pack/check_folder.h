// Every fault of a show's authoring files, all of them at once.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kaori::authoring {

// What was found in a folder, one line each: file, line where there is one, item, reason.
struct FolderCheck {
  std::vector<std::string> faults;  // With any of them there is no pack; without, AuthorShow will succeed.
  // What can be packed and should not be shown: expressions that fold the skin of a face. Looked for where
  // there is no fault.
  std::vector<std::string> flaws;
};

// Reads faces, looks, expressions and script of `folder`, however much of it is wrong, and sculpts the faces
// where that can be done; paints nothing. Blocks for about two seconds, on all processors.
FolderCheck CheckFolder(const std::filesystem::path& folder);

// One a line.
std::string JoinFaults(const std::vector<std::string>& faults);

}  // namespace kaori::authoring
