// The parts of show.toml, each in a file of its own: names_in_show.cpp, motion_file.cpp, controls_file.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "appliance/authoring/script/show_file.h"
#include "appliance/core/show/show.h"
#include "appliance/core/toml/nearest.h"
#include "appliance/core/toml/section.h"

namespace kaori::authoring {

// What all parts are read with. Borrows the show and the faults.
struct Script {
  std::filesystem::path folder;  // Of show.toml: pictures and sounds lie beside it.
  KnownNames known;
  show::Show& show;
  toml::Faults& faults;
  std::map<std::string, std::string> used_keys{};  // By name: "scene \"night\" (line 12)".
};

// The number of the item that is called `name`; 0, and a fault of `key`, where there is none.
template <class Items>
std::uint16_t IndexOf(toml::Section& section, std::string_view key, const char* kind, const Items& items,
                      const std::string& name) {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].name == name) return static_cast<std::uint16_t>(i);
  section.Fault(key, fmt::format("there is no {} \"{}\"{}", kind, name, toml::DidYouMeanOneOf(name, items)));
  return 0;
}

// The same for faces and expressions of the cast, whose names may not be known; 0 without a fault then.
std::uint16_t FaceNamed(Script& script, toml::Section& section, std::string_view key,
                        const std::string& name);
std::uint16_t ExpressionNamed(Script& script, toml::Section& section, std::string_view key,
                              const std::string& name);

// "wire" .. "soft", as numbers of scene::Style.
std::uint16_t StyleNamed(toml::Section& section, std::string_view key, const std::string& name);

// The HID usage of the key that `name` names; 0, and a fault of `key`, where there is none, where the box
// uses it, or where something else of the show has it. `user` is who wants it: "scene \"night\"".
std::uint16_t KeyNamed(Script& script, toml::Section& section, std::string_view key, const std::string& name,
                       const std::string& user);

// A [[scene]] or [[motion]] by its own name: faults call it "scene \"night\"" rather than "scene[3]".
toml::Section Named(Script& script, const char* kind, const toml::Section& section, std::size_t number);

show::Motion ReadMotion(Script& script, toml::Section section);

// Fills the 32 buttons, and the keys of [keys]. Scenes must have been read.
void ReadButtons(Script& script, const toml::Section& file);
void ReadKeys(Script& script, toml::Section keys);

}  // namespace kaori::authoring
