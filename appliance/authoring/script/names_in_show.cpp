#include <algorithm>
#include <array>
#include <vector>

#include <fmt/ranges.h>

#include "appliance/authoring/script/key_names.h"
#include "appliance/authoring/script/show_parts.h"
#include "appliance/authoring/script/taken_keys.h"
#include "appliance/core/show/cue_names.h"
#include "render/scene/scene.h"

namespace kaori::authoring {
// Where the cast's names are not known any name will do: what keeps them from being known is
// a fault of another file.
std::uint16_t FaceNamed(Script& script, toml::Section& section, std::string_view key,
                        const std::string& name) {
  return script.known.faces ? IndexOf(section, key, "face", script.show.cast.faces, name) : std::uint16_t{0};
}

std::uint16_t ExpressionNamed(Script& script, toml::Section& section, std::string_view key,
                              const std::string& name) {
  if (!script.known.expressions) return 0;
  return IndexOf(section, key, "expression", script.show.cast.expressions, name);
}

std::uint16_t StyleNamed(toml::Section& section, std::string_view key, const std::string& name) {
  const auto it = std::ranges::find(scene::kStyleNames, name);
  if (it != scene::kStyleNames.end()) return static_cast<std::uint16_t>(it - scene::kStyleNames.begin());
  section.Fault(key, fmt::format("there is no style \"{}\"; styles are wire, flat, bare, hair, soft", name));
  return 0;
}

// The number is given even where it is a fault. `otherwise` is judged as well, and must lie within the
// bounds.
float Between(toml::Section& section, std::string_view key, float otherwise, float most, const char* unit) {
  return section.FloatOr(key, otherwise, 0, most, unit);
}

std::uint16_t CueVerbNamed(toml::Section& section, std::string_view key, const std::string& name) {
  const auto it = std::ranges::find(show::kCueVerbNames, name);
  if (it != show::kCueVerbNames.end()) return static_cast<std::uint16_t>(it - show::kCueVerbNames.begin());
  section.Fault(key, fmt::format("the cue list knows no \"{}\"; it knows {}", name,
                                 fmt::join(show::kCueVerbNames, ", ")));
  return 0;
}

// Of two that want one key the first in the file's order of reading keeps it, and the
// fault is the second one's.
std::uint16_t KeyNamed(Script& script, toml::Section& section, std::string_view key, const std::string& name,
                       const std::string& user) {
  const auto usage = KeyUsage(name);
  if (!usage) {
    section.Fault(
        key,
        fmt::format("there is no key \"{}\"; keys are a to z, 0 to 9, f1 to f12, enter, backspace, escape",
                    name));
    return 0;
  }
  if (const auto use = UseOfTheBox(*usage); !use.empty()) {
    section.Fault(key, fmt::format("the key \"{}\" belongs to the box: {}", name, use));
    return 0;
  }
  // In [keys] the key is its own entry; elsewhere it stands under "key".
  const toml::Value* value = section.Find(key);
  const int line = value != nullptr ? value->line : section.table().line;
  const auto [other, is_new] = script.used_keys.try_emplace(name, fmt::format("{} in line {}", user, line));
  if (!is_new)
    section.Fault(key, fmt::format("the key \"{}\" is given twice: it is that of {}", name, other->second));
  return *usage;
}

// The same table under another name; borrows the script's faults.
toml::Section Named(Script& script, const char* kind, const toml::Section& section, std::size_t number) {
  const toml::Value* name = section.Find("name");
  const bool named = name != nullptr && name->kind == toml::Value::Kind::kText && !name->text.empty();
  return {section.table(),
          named ? fmt::format("{} \"{}\"", kind, name->text) : fmt::format("{}[{}]", kind, number),
          script.faults};
}

}  // namespace kaori::authoring
