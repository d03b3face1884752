// Every fault of a show's authoring files, all of them at once.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kaori::authoring {

// Reads faces, looks, expressions and script of `folder`, however much of it is wrong, and sculpts the faces
// where that can be done; paints nothing. One line for each fault: file, line where there is one, item,
// reason. Empty: AuthorShow will succeed. About a second.
std::vector<std::string> CheckFolder(const std::filesystem::path& folder);

// One a line.
std::string JoinFaults(const std::vector<std::string>& faults);

}  // namespace kaori::authoring
