#include "drivers/base/folder.h"

#include <algorithm>

namespace kaori {

// Not by a range-based loop: its steps throw where only the first look at the folder is asked for an error.
Result<std::vector<std::filesystem::path>> ListFolder(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  std::error_code error;
  std::filesystem::directory_iterator at(folder, error), end;
  while (!error && at != end) {
    paths.push_back(at->path());
    at.increment(error);
  }
  if (error) return Fail(static_cast<std::errc>(error.value()), "list " + folder.string());
  std::ranges::sort(paths);
  return paths;
}

bool IsThere(const std::filesystem::path& path) {
  std::error_code unknown;
  return std::filesystem::exists(path, unknown);
}

}  // namespace kaori
