#include "appliance/core/showlog/log_folder.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <system_error>

#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"

namespace kaori::showlog {
namespace {

// The beginning of the file is enough: the roles file is the one long part of a head, and 1 KB has room for
// the rest.
std::optional<LogHead> HeadOf(const std::filesystem::path& file) {
  const auto text = ReadBeginning(file, kMostRoles_bytes + 1024);
  if (!text) return std::nullopt;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text->data());
  auto read = ReadHead({bytes, text->size()});
  if (!read) return std::nullopt;
  return std::move(read->head);
}

}  // namespace

std::vector<LogOnDisk> LogsIn(const std::filesystem::path& folder) {
  std::vector<LogOnDisk> logs;
  std::error_code none;
  for (const auto& path : ListFolder(folder).value_or(std::vector<std::filesystem::path>{})) {
    int number = 0;
    const std::string name = path.filename().string();
    if (!name.ends_with(kLogEnding) || std::sscanf(name.c_str(), "%9d-", &number) != 1) continue;
    logs.push_back({path, number, std::filesystem::file_size(path, none), HeadOf(path)});
  }
  std::ranges::sort(logs, {}, &LogOnDisk::number);
  return logs;
}

bool IsSameEvening(const std::optional<LogHead>& a, const std::optional<LogHead>& b) {
  return a && b && IsSameEvening(*a, *b);
}

}  // namespace kaori::showlog
