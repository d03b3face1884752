// Folders that are made for a moment: for roles of a log, and for a copy of what was made on the box.
#pragma once

#include <filesystem>

namespace kaori::report {

// A folder of nobody else's, gone with the object. Empty where it could not be made.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Copies the expressions that were made on the box, *.toml, from its folder into another one: the stage writes there at
// any time, and to open such a folder would be to write in it. What cannot be copied is missing. Blocks for the disk.
void CopyOwn(const std::filesystem::path& own, const std::filesystem::path& into);

}  // namespace kaori::report
