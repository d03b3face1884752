// The logs that lie in a folder, evening by evening.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "appliance/core/showlog/format.h"

namespace kaori::showlog {

inline constexpr std::string_view kLogEnding = ".kaorilog";

// A log that lies in the folder.
struct LogOnDisk {
  std::filesystem::path file;
  int number = 0;  // With which its name begins; numbers rise, whatever the box's clock says.
  std::uintmax_t bytes = 0;
  std::optional<LogHead> head;  // None: it cannot be read, and counts as an evening.
};

// Oldest first; other files are left alone. No folder: none. Blocks for the disk. Any thread.
std::vector<LogOnDisk> LogsIn(const std::filesystem::path& folder);

// A head that cannot be read belongs to no evening but its own.
bool IsSameEvening(const std::optional<LogHead>& a, const std::optional<LogHead>& b);

}  // namespace kaori::showlog
