#include "appliance/programs/status/facts.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <system_error>

#include "appliance/core/store/box_name.h"
#include "appliance/core/store/refused_usb.h"
#include "appliance/programs/status/screens_file.h"
#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"

namespace kaori::status {
namespace {

// kaori-boot leaves an empty file that is named after the profile.
constexpr const char* kProfiles[] = {"stage", "kiosk", "bench"};
constexpr std::size_t kMostLines = 64;  // Of any file.

// Empty lines are left out; a file that cannot be read has none.
std::vector<std::string> LinesOf(const std::filesystem::path& path) {
  std::vector<std::string> lines;
  std::istringstream file(ReadFile(path).value_or(""));
  for (std::string line; lines.size() < kMostLines && std::getline(file, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

std::string WordOf(const std::filesystem::path& path) {
  const auto lines = LinesOf(path);
  return lines.empty() ? std::string() : lines.front();
}

// The sentences about devices that were refused with this weight, by the order of their ports.
std::vector<std::string> UsbSentences(const std::filesystem::path& folder, store::Weight weight) {
  std::vector<std::string> lines;
  for (const auto& file : ListFolder(folder).value_or(std::vector<std::filesystem::path>{})) {
    const auto refused = store::ParseRefusedUsb(ReadFile(file).value_or(""));
    if (!refused || refused->weight != weight || lines.size() >= kMostLines) continue;
    lines.push_back(refused->english);
    if (!refused->japanese.empty()) lines.push_back(refused->japanese);
  }
  return lines;
}

}  // namespace

// All files are small and lie in memory (/run), so that reading them anew each second costs next to nothing.
Facts ReadFacts(const Places& places) {
  Facts facts{store::NameWithNumber(WordOf(places.settings / "name"), WordOf(places.settings / "machine-id")),
              {},
              WordOf(places.settings / "root_hash"),
              WordOf(places.settings / "slot"),
              WordOf(places.settings / "status_screen"),
              WordOf(places.settings / "monitor_screen"),
              LinesOf(places.settings / "faults"),
              ParseScreens(ReadFile(places.screens).value_or("")),
              LinesOf(places.notices / "power"),
              LinesOf(places.shows)};
  facts.update = LinesOf(places.update);
  facts.usb = UsbSentences(places.usb, store::Weight::kNamed);
  for (const auto& lines :
       {LinesOf(places.spoilt), LinesOf(places.reset), UsbSentences(places.usb, store::Weight::kFault)})
    facts.faults.insert(facts.faults.end(), lines.begin(), lines.end());
  std::error_code none;
  for (const char* profile : kProfiles)
    if (std::filesystem::exists(places.settings / profile, none)) facts.profile = profile;
  return facts;
}

}  // namespace kaori::status
