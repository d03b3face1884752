#include "appliance/programs/report/own_copy.h"

#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

#include "drivers/base/folder.h"

namespace kaori::report {

TemporaryFolder::TemporaryFolder() {
  std::error_code none;
  std::string name = (std::filesystem::temp_directory_path(none) / "kaori-log-XXXXXX").string();
  if (::mkdtemp(name.data()) != nullptr) path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code none;
  if (!path_.empty()) std::filesystem::remove_all(path_, none);
}

// Regular files alone: nothing that is linked from elsewhere is followed.
void CopyOwn(const std::filesystem::path& own, const std::filesystem::path& into) {
  for (const auto& file : ListFolder(own).value_or(std::vector<std::filesystem::path>{})) {
    std::error_code odd;
    if (file.extension() == ".toml" &&
        std::filesystem::is_regular_file(std::filesystem::symlink_status(file, odd)))
      std::filesystem::copy_file(file, into / file.filename(), odd);
  }
}

}  // namespace kaori::report
