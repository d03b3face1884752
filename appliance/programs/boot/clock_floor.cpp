#include "appliance/programs/boot/clock_floor.h"

#include <sys/stat.h>

#include <algorithm>
#include <ctime>

#include "drivers/base/folder.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;

// own/log/FILE lies so deep. The start waits for this, so it does not look everywhere.
constexpr int kDeepest = 3;

// A link is not followed. 1970 where nothing can be read.
Date Newest(const fs::path& path, int deepest) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return Date{};
  Date newest{std::chrono::seconds(status.st_mtim.tv_sec)};
  if (!S_ISDIR(status.st_mode) || deepest == 0) return newest;
  if (const auto inside = ListFolder(path))
    for (const fs::path& entry : *inside) newest = std::max(newest, Newest(entry, deepest - 1));
  return newest;
}

}  // namespace

std::optional<Date> MendedClock(Date now, Date made, const fs::path& kept) {
  if (now >= made) return std::nullopt;
  return std::max(made, Newest(kept, kDeepest));
}

std::string Shown(Date date) {
  constexpr const char* kForm = "%Y-%m-%d %H:%M UTC";
  constexpr std::size_t kLongest = 32;
  const std::time_t seconds = date.time_since_epoch().count();
  std::tm parts{};
  std::string text(kLongest, '\0');
  if (::gmtime_r(&seconds, &parts) == nullptr) return "an unknown date";
  text.resize(std::strftime(text.data(), text.size(), kForm, &parts));
  return text;
}

}  // namespace kaori::boot
