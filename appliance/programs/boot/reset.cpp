#include "appliance/programs/boot/reset.h"

#include <system_error>

#include "drivers/base/folder.h"
#include "drivers/base/whole_file.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOfFileSystem = "lost+found";  // Where e2fsck puts what it finds.

// What lies in a folder, but for one file.
Result<void> EmptyFolder(const fs::path& folder, const fs::path& but, const Remove& remove) {
  const auto entries = ListFolder(folder);
  if (!entries) return tl::unexpected(entries.error());
  for (const fs::path& entry : *entries)
    if (entry != but)
      if (auto ok = remove(entry); !ok) return ok;
  return {};
}

Result<void> EmptyPartition(const fs::path& data, const Remove& remove) {
  const auto entries = ListFolder(data);
  if (!entries) return tl::unexpected(entries.error());
  for (const fs::path& entry : *entries) {
    std::error_code none;
    const bool is_folder = fs::is_directory(fs::symlink_status(entry, none));
    if (is_folder && entry.filename() == kOfFileSystem) continue;
    auto ok = is_folder ? EmptyFolder(entry, data / kResetMarker, remove) : remove(entry);
    if (!ok) return ok;
  }
  return {};
}

}  // namespace

Result<void> RemoveAll(const fs::path& path) {
  std::error_code failed;
  fs::remove_all(path, failed);
  if (failed) return Fail(static_cast<std::errc>(failed.value()), "remove " + path.string());
  return {};
}

Result<bool> ResetIfAsked(const fs::path& data, const Remove& remove) {
  if (!IsThere(data / kResetMarker)) return false;
  if (auto ok = EmptyPartition(data, remove); !ok) return tl::unexpected(ok.error());
  if (auto ok = SyncFileSystem(data); !ok) return tl::unexpected(ok.error());
  if (auto ok = remove(data / kResetMarker); !ok) return tl::unexpected(ok.error());
  if (auto ok = SyncFileSystem(data); !ok) return tl::unexpected(ok.error());
  return true;
}

std::string Reset(const fs::path& data) {
  const auto reset = ResetIfAsked(data);
  if (!reset)
    return "the factory reset is not done, and the next start tries again: " + reset.error().message();
  return *reset ? "a factory reset was asked for and is done: the shows, settings and expressions of before "
                  "are gone"
                : "";
}

}  // namespace kaori::boot
