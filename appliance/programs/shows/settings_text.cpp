#include "appliance/programs/shows/settings_text.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "appliance/core/toml/quoted.h"
#include "appliance/core/toml/value.h"
#include "drivers/base/read_file.h"

namespace kaori::shows {
namespace {

constexpr std::size_t kMostSettings_bytes = std::size_t{64} << 10U;
constexpr std::size_t kLongestText = 200;  // Longer than any setting; a key or a certificate may be.

// Parts of names under which people keep what nobody else is to know.
constexpr std::array<std::string_view, 9> kSecrets{"pass", "secret", "token", "key",       "code",
                                                   "pin",  "psk",    "cert",  "credential"};
// Names that have such a part and are none.
constexpr std::array<std::string_view, 1> kNoSecrets{"keyboard"};

bool IsSecret(std::string_view name) {
  std::string lower(name);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (std::ranges::find(kNoSecrets, lower) != kNoSecrets.end()) return false;
  return std::ranges::any_of(kSecrets,
                             [&](std::string_view part) { return lower.find(part) != std::string::npos; });
}

std::string InOneLine(const toml::Value& value) {
  switch (value.kind) {
    case toml::Value::Kind::kNumber:
      return fmt::format("{}", value.number);
    case toml::Value::Kind::kSwitch:
      return value.on ? "true" : "false";
    default:
      return value.text.size() > kLongestText ? "(left out)" : toml::Quoted(value.text);
  }
}

// Items of a list have their number in place of a name; tables within lists are looked through as all others.
void Add(const std::string& name, const toml::Value& value, std::string& text) {
  if (value.kind == toml::Value::Kind::kTable) {
    for (const auto& [key, item] : value.table) {
      const std::string whole = name.empty() ? key : fmt::format("{}.{}", name, key);
      if (IsSecret(key))
        text += whole + " = (left out)\n";
      else
        Add(whole, item, text);
    }
  } else if (value.kind == toml::Value::Kind::kList) {
    for (std::size_t i = 0; i < value.list.size(); ++i)
      Add(fmt::format("{}[{}]", name, i), value.list[i], text);
  } else {
    text += name + " = " + InOneLine(value) + "\n";
  }
}

}  // namespace

std::string SettingsText(const std::filesystem::path& file) {
  const auto text = ReadFile(file, {.most_bytes = kMostSettings_bytes, .most_levels = kMostLevels});
  if (!text) return text.error().message();
  const auto settings = toml::Parse(*text, file.filename().string());
  if (!settings) return "they have a fault: " + settings.error().message();
  std::string shown;
  Add("", *settings, shown);
  return shown;
}

}  // namespace kaori::shows
