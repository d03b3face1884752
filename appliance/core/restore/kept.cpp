#include "appliance/core/restore/kept.h"

#include <algorithm>

#include "appliance/core/store/choice.h"
#include "drivers/base/folder.h"

namespace kaori::restore {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kKeys = "settings/keys/", kOwn = "own/", kLips = "lips/lips.settings",
                           kReports = "own/log/", kShows = "shows/";

// One name, neither hidden nor with a letter that would make two of it or forge a line of a list.
bool IsPlainName(std::string_view name) {
  const auto is_bad = [](char c) {
    return static_cast<unsigned char>(c) < 0x20U || c == 0x7F || c == '/' || c == '\\';
  };
  return !name.empty() && name.front() != '.' && std::ranges::none_of(name, is_bad);
}

bool IsIn(std::string_view path, std::string_view folder, std::string_view end) {
  return path.size() <= kLongestPath && path.starts_with(folder) && path.ends_with(end) &&
         path.size() > folder.size() + end.size() && IsPlainName(path.substr(folder.size()));
}

// The regular files of data/folder whose path `belongs`.
template <class Belongs>
Result<void> AddFiles(const fs::path& data, std::string_view folder, const Belongs& belongs,
                      std::vector<std::string>& paths) {
  if (!IsThere(data / folder)) return {};
  const auto files = ListFolder(data / folder);
  if (!files) return tl::unexpected(files.error());
  for (const fs::path& file : *files) {
    const std::string path = std::string(folder) + file.filename().string();
    std::error_code odd;
    if (belongs(path) && fs::is_regular_file(fs::symlink_status(file, odd))) paths.push_back(path);
  }
  return {};
}

}  // namespace

// A list of what belongs, and not of what does not: a file that a later version keeps is left alone by this one.
bool IsRestored(std::string_view path) {
  return path == kSettings || path == kLips || IsIn(path, kKeys, ".pub") || IsIn(path, kOwn, ".toml");
}

bool IsPack(std::string_view path) {
  constexpr std::string_view kEnd = ".kaori";
  return IsIn(path, kShows, kEnd) &&
         store::IsId(path.substr(kShows.size(), path.size() - kShows.size() - kEnd.size()));
}

// Whatever the stage calls its files.
bool IsReport(std::string_view path) {
  return IsIn(path, kReports, "");
}

Result<std::vector<std::string>> RestoredPaths(const fs::path& data) {
  std::vector<std::string> paths;
  for (const std::string_view folder :
       {std::string_view("lips/"), kOwn, std::string_view("settings/"), kKeys})
    if (auto ok = AddFiles(data, folder, IsRestored, paths); !ok) return tl::unexpected(ok.error());
  return paths;
}

Result<std::vector<std::string>> ReportPaths(const fs::path& data) {
  std::vector<std::string> paths;
  if (auto ok = AddFiles(data, kReports, IsReport, paths); !ok) return tl::unexpected(ok.error());
  return paths;
}

}  // namespace kaori::restore
