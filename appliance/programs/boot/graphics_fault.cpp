#include "appliance/programs/boot/graphics_fault.h"

#include <algorithm>
#include <array>
#include <optional>

#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;

// What the kernel's log says of a file that it does not find (drivers/base/firmware_loader/main.c, and
// drivers/gpu/drm/i915/gt/uc/intel_uc_fw.c, which asks without that first line).
struct Complaint {
  std::string_view before, after;  // Of the file's name.
};
constexpr std::array kComplaints{Complaint{"Direct firmware load for ", " failed with error"},
                                 Complaint{"GuC firmware ", ": fetch failed"}};

// Folders of drivers that draw; and in them, by a part of the name, what a card draws without.
constexpr std::array<std::string_view, 2> kDrivers{"amdgpu/", "i915/"};
constexpr std::array<std::string_view, 3> kSpared{"_dmc_", "_dmc.", "_huc"};

constexpr std::string_view kDisplay = "0x03";  // Display controllers, by the first byte of PCI's class.

std::optional<std::string_view> NameIn(std::string_view line) {
  for (const auto& [before, after] : kComplaints) {
    const auto at = line.find(before);
    if (at == std::string_view::npos) continue;
    const auto end = line.find(after, at + before.size());
    if (end != std::string_view::npos) return line.substr(at + before.size(), end - at - before.size());
  }
  return std::nullopt;
}

bool IsNeeded(std::string_view name) {
  const auto is_part = [&](std::string_view part) { return name.find(part) != std::string_view::npos; };
  const auto begins = [&](std::string_view folder) { return name.starts_with(folder); };
  return std::ranges::any_of(kDrivers, begins) && std::ranges::none_of(kSpared, is_part);
}

// A number of sysfs without its "0x" and the end of its line.
std::string Digits(const fs::path& file) {
  std::string text = ReadFile(file).value_or("");
  text.erase(std::min(text.find('\n'), text.size()));
  return text.starts_with("0x") ? text.substr(2) : text;
}

}  // namespace

std::vector<std::string> WantedFirmware(std::string_view kernel_log) {
  std::vector<std::string> wanted;
  while (!kernel_log.empty()) {
    const auto end = std::min(kernel_log.find('\n'), kernel_log.size());
    const auto name = NameIn(kernel_log.substr(0, end));
    kernel_log.remove_prefix(std::min(end + 1, kernel_log.size()));
    if (name && IsNeeded(*name) && std::ranges::find(wanted, *name) == wanted.end())
      wanted.emplace_back(*name);
  }
  return wanted;
}

// The link named "driver" is there as long as a driver has the device.
std::vector<std::string> UndrivenCards(const fs::path& devices) {
  std::vector<std::string> cards;
  for (const fs::path& device : ListFolder(devices).value_or(std::vector<fs::path>{})) {
    if (!ReadFile(device / "class").value_or("").starts_with(kDisplay)) continue;
    if (IsThere(device / "driver")) return {};
    cards.push_back(Digits(device / "vendor") + ":" + Digits(device / "device"));
  }
  return cards;
}

std::vector<std::string> GraphicsFaults(const std::vector<std::string>& undriven,
                                        const std::vector<std::string>& wanted) {
  std::vector<std::string> faults;
  for (const std::string& name : wanted)
    faults.push_back("the graphics card wants the file " + name +
                     ", which is not in the image: the processor draws instead");
  if (wanted.empty())
    for (const std::string& card : undriven)
      faults.push_back("the graphics card " + card +
                       " has no driver in the image: the processor draws instead");
  return faults;
}

}  // namespace kaori::boot
