#include "appliance/programs/shows/settings_check.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "appliance/core/toml/nearest.h"
#include "appliance/core/toml/value.h"
#include "appliance/programs/boot/profile.h"
#include "appliance/programs/input/settings.h"

namespace kaori::shows {
namespace {

// The sections of box.toml that somebody reads; those of kaori-boot hold no further ones.
constexpr std::array<std::string_view, 3> kOfBoot{"lines", "clock", "network"};
constexpr std::array<std::string_view, 4> kOfInput{"dials", "keyboard", "pointer", "stick"};

template <class Names>
bool Has(const Names& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

// Whoever reads a part of the file passes over the sections of others, and so over those that nobody reads.
std::string FaultOfSections(const toml::Value& settings) {
  std::vector<std::string_view> known(kOfBoot.begin(), kOfBoot.end());
  known.insert(known.end(), kOfInput.begin(), kOfInput.end());
  for (const auto& [name, value] : settings.table) {
    if (value.kind == toml::Value::Kind::kList)
      return fmt::format("line {}: {} is a list; no setting is", value.line, name);
    if (value.kind != toml::Value::Kind::kTable) continue;
    if (!Has(known, name))
      return fmt::format("line {}: there is no section [{}]{}", value.line, name,
                         toml::DidYouMean(name, known));
    // Sections of the input program may hold further ones: its own reader checks them.
    for (const auto& [inner, part] : value.table)
      if (Has(kOfBoot, name) && part.kind == toml::Value::Kind::kTable)
        return fmt::format("line {}: there is no section [{}.{}]", part.line, name, inner);
  }
  return {};
}

}  // namespace

// The order is that in which a person would look: can it be read at all, then line by line from its top.
std::string FaultOfSettings(const std::string& text, const std::filesystem::path& zones) {
  if (text.size() > kMostSettings_bytes) return "it is longer than any settings";
  const auto settings = toml::Parse(text, "box.toml");
  if (!settings) return settings.error().message();
  auto profile = boot::ReadProfile(text);
  if (!profile.fault.empty()) return profile.fault;
  if (auto unknown = DropUnknownZone(profile, zones); !unknown.empty()) return unknown;
  if (const auto input = input::ParseBoxSettings(text, "box.toml"); !input) return input.error().message();
  return FaultOfSections(*settings);
}

}  // namespace kaori::shows
