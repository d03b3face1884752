#include "appliance/programs/shows/settings_text.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "appliance/core/toml/quoted.h"
#include "appliance/core/toml/value.h"
#include "appliance/programs/shows/settings_check.h"
#include "drivers/base/read_file.h"

namespace kaori::shows {
namespace {

constexpr std::size_t kLongestText = 200;  // Longer than any setting; a key or a certificate may be.

// Parts of names under which people keep what nobody else is to know.
constexpr std::array<std::string_view, 9> kSecrets{"pass", "secret", "token", "key",       "code",
                                                   "pin",  "psk",    "cert",  "credential"};
// Names that have such a part and are none.
constexpr std::array<std::string_view, 1> kNoSecrets{"keyboard"};

// Letters are compared without regard to capitals, and in ASCII alone. A name that is hidden without
// need does less harm than a password in a file that is sent to somebody.
bool IsSecret(std::string_view name) {
  std::string lower(name);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (std::ranges::find(kNoSecrets, lower) != kNoSecrets.end()) return false;
  return std::ranges::any_of(kSecrets,
                             [&](std::string_view part) { return lower.find(part) != std::string::npos; });
}

// The longest texts are left out as a whole: half a certificate helps nobody.
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

// A name with its value, both as text.
using Lines = std::vector<std::pair<std::string, std::string>>;

// Items of a list have their number in place of a name; tables within lists are looked through as all others.
void Add(const std::string& name, const toml::Value& value, bool with_secrets, Lines& lines) {
  if (value.kind == toml::Value::Kind::kTable) {
    for (const auto& [key, item] : value.table) {
      const std::string whole = name.empty() ? key : fmt::format("{}.{}", name, key);
      if (!with_secrets && IsSecret(key))
        lines.emplace_back(whole, "(left out)");
      else
        Add(whole, item, with_secrets, lines);
    }
  } else if (value.kind == toml::Value::Kind::kList) {
    for (std::size_t i = 0; i < value.list.size(); ++i)
      Add(fmt::format("{}[{}]", name, i), value.list[i], with_secrets, lines);
  } else {
    lines.emplace_back(name, InOneLine(value));
  }
}

// In the order of their names, which two texts are compared by.
std::map<std::string, std::string> SettingsOf(const std::string& text) {
  const auto settings = toml::Parse(text, "");
  Lines lines;
  if (settings) Add("", *settings, true, lines);
  return {lines.begin(), lines.end()};
}

}  // namespace

// The result is for people: a fault of the file takes the place of its settings.
std::string SettingsText(const std::filesystem::path& file) {
  const auto text = ReadFile(file, {.most_bytes = kMostSettings_bytes, .most_levels = kMostLevels});
  if (!text) return text.error().message();
  const auto settings = toml::Parse(*text, file.filename().string());
  if (!settings) return "they have a fault: " + settings.error().message();
  Lines lines;
  Add("", *settings, false, lines);
  std::string shown;
  for (const auto& [name, value] : lines) shown += fmt::format("{} = {}\n", name, value);
  return shown;
}

// First what comes and changes, then what goes; each in the order of the names.
std::vector<std::string> SettingsDifferences(const std::string& before, const std::string& after) {
  const auto old = SettingsOf(before), fresh = SettingsOf(after);
  std::vector<std::string> lines;
  for (const auto& [name, value] : fresh) {
    const auto was = old.find(name);
    if (was == old.end())
      lines.push_back(fmt::format("new     {}  {}", name, value));
    else if (was->second != value)
      lines.push_back(fmt::format("changed {}  {} -> {}", name, was->second, value));
  }
  for (const auto& [name, value] : old)
    if (!fresh.contains(name)) lines.push_back(fmt::format("gone    {}  {}", name, value));
  return lines;
}

}  // namespace kaori::shows
