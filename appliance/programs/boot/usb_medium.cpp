#include "appliance/programs/boot/usb_medium.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>

#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"
#include "drivers/base/root_disk.h"
#include "drivers/base/unique_fd.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBus = "usb";  // "usb2" is the second bus, and the hub at its root.

bool IsBus(std::string_view name) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return name.starts_with(kBus) && name.size() > kBus.size() &&
         std::ranges::all_of(name.substr(kBus.size()), is_digit);
}

// The kernel's names: "2-1.4" is a device, "2-1.4:1.0" an interface of it.
bool IsInterface(std::string_view name) {
  return name.find(':') != std::string_view::npos;
}

// False where there is no such file, or the kernel does not want it.
bool Write(const fs::path& file, std::string_view text) {
  const UniqueFd fd(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  return fd.valid() && ::write(fd.get(), text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

// What a file of sysfs says, without the end of its line.
bool Says(const fs::path& file, std::string_view text) {
  const std::string said = ReadFile(file).value_or("");
  return std::string_view(said).substr(0, said.find('\n')) == text;
}

}  // namespace

// Devices are folders within those of their hubs; the first interface ends the way.
std::vector<std::string> UsbMedium(const fs::path& blocks) {
  const auto disk = DiskOfRoot(blocks);
  if (!disk) return {};
  std::vector<std::string> medium;
  for (const fs::path& part : *disk) {
    const std::string name = part.string();
    if (!medium.empty() && IsInterface(name)) break;
    if (!medium.empty() || IsBus(name)) medium.push_back(name);
  }
  return medium;
}

// The buses first: a device that comes meanwhile is refused already.
std::vector<std::string> DeauthoriseOthers(const fs::path& devices, const std::vector<std::string>& medium) {
  const auto all = ListFolder(devices).value_or(std::vector<fs::path>{});
  bool lets_in = false;
  for (const fs::path& device : all)
    if (IsBus(device.filename().string()) && !Says(device / "authorized_default", "0"))
      lets_in = Write(device / "authorized_default", "0") || lets_in;
  if (!lets_in) return {};
  std::vector<std::string> cut_off;
  for (const fs::path& device : all) {
    const std::string name = device.filename().string();
    const bool stays = IsBus(name) || IsInterface(name) || std::ranges::find(medium, name) != medium.end();
    if (!stays && Says(device / "authorized", "1") && Write(device / "authorized", "0"))
      cut_off.push_back(name);
  }
  return cut_off;
}

}  // namespace kaori::boot
