// The parts of show.toml, each in a file of its own: names_in_show.cpp, motion_file.cpp, controls_file.cpp;
// and takes.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <tl/expected.hpp>

#include "appliance/authoring/script/show_file.h"
#include "appliance/core/show/show.h"
#include "appliance/core/toml/nearest.h"
#include "appliance/core/toml/section.h"

namespace kaori::authoring {

// What all parts are read with. Borrows the show and the faults; lives for one file.
struct Script {
  // Of show.toml: pictures and sounds lie beside it.
  std::filesystem::path folder;
  KnownNames known;
  show::Show& show;
  toml::Faults& faults;
  // Who has a key, by its name: "scene "night" in line 12". Two users of one key are a fault.
  std::map<std::string, std::string> used_keys{};
  bool knows_cues = true;  // False: cues.toml could not be read, and no number is said to be missing.
  std::vector<std::string> faults_of_takes{};  // Lines, each with its own file.
};

// The number of the item that is called `name`; 0, and a fault of `key` with a name that may be meant, where
// there is none. `kind` is the word for such items: "face".
template <class Items>
std::uint16_t IndexOf(toml::Section& section, std::string_view key, const char* kind, const Items& items,
                      const std::string& name) {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].name == name) return static_cast<std::uint16_t>(i);
  section.Fault(key, fmt::format("there is no {} \"{}\"{}", kind, name, toml::DidYouMeanOneOf(name, items)));
  return 0;
}

// The same for faces and expressions of the cast, whose names may not be known (KnownNames); 0 without
// a fault then.
std::uint16_t FaceNamed(Script& script, toml::Section& section, std::string_view key,
                        const std::string& name);
// By the cast's list of expressions, of every kind.
std::uint16_t ExpressionNamed(Script& script, toml::Section& section, std::string_view key,
                              const std::string& name);

// "wire" .. "soft", as numbers of scene::Style; 0, and a fault of `key`, for other names.
std::uint16_t StyleNamed(toml::Section& section, std::string_view key, const std::string& name);

// A number of 0 to `most`; others are a fault, NaN too. `unit` follows the number: " s".
float Between(toml::Section& section, std::string_view key, float otherwise, float most, const char* unit);

// "go" .. "blackout", as numbers of show::CueVerb.
std::uint16_t CueVerbNamed(toml::Section& section, std::string_view key, const std::string& name);

// The HID usage of the key that `name` names; 0, and a fault of `key`, where there is none, where the box
// uses it, or where something else of the show has it. `user` is who wants it: "scene "night"".
std::uint16_t KeyNamed(Script& script, toml::Section& section, std::string_view key, const std::string& name,
                       const std::string& user);

// A [[scene]] or [[motion]] by its own name: faults call it "scene "night"" rather than "scene[3]". `number`
// counts from 1.
toml::Section Named(Script& script, const char* kind, const toml::Section& section, std::size_t number);

// One [[motion]]: name, key, sound, layer, and a curve for each other key: a list of pairs [second, value] that
// starts and ends at 0. Angles are degrees in the file and radians in the motion.
show::Motion ReadMotion(Script& script, toml::Section section);

// The expression that a curve moves, by its name; 0 where nobody knows the names (KnownNames). Else what is
// wrong with it.
tl::expected<std::uint16_t, std::string> ChannelNamed(const Script& script, const std::string& name);

// The takes beside show.toml, takes/NAME.toml in the order of their names, as motions behind those of
// show.toml. Their faults go to Script::faults_of_takes. A take with faults is there by its name, so that who
// calls it is not faulted too.
void ReadTakes(Script& script);

// [gaze]: what she can look at, by name, as three numbers in metres. The show then has the house first and
// the camera, whether the file names them or not.
void ReadGazeTargets(Script& script, toml::Section gaze);
// "seat 12" of those, or "nobody".
std::int32_t GazeNamed(Script& script, toml::Section& section, std::string_view key, const std::string& name);
// life = 0.4 for all parts, or { blink = 1, glance = 0.4 }: parts that are not named are `otherwise`.
show::LifeAmounts LifeAt(toml::Section& section, std::string_view key, float otherwise);

// Parts of a cue (cue_parts.cpp). motion = "nod", or take = { name = "greeting", layer = "under", gain = 0.8,
// from_s = 2.5 }: a take is a motion that somebody played. "none" ends what plays.
void ReadCueMotion(Script& script, toml::Section& section, show::Cue& cue);
// A motion that loops has no end at which something could begin.
void CheckFollow(Script& script, toml::Section& section, const show::Cue& cue);
// wait_for: one condition, and an end of its own for it, since a sensor that fails must not hold the evening.
show::CueWait ReadCueWait(Script& script, toml::Section& section);

// The cue list, of cues.toml. Scenes, motions, gaze targets and roles must have been read.
void ReadCueList(Script& script, toml::Section file);

// The lobby, of lobby.toml. Cues, motions and gaze targets must have been read.
void ReadLobbyFile(Script& script, toml::Section file);

// Fills the 32 buttons of a sheet, which stand in `list` as rows of texts such as "face kaori". Scenes, motions and
// cues must have been read, since buttons name them; so it is for all that follow.
void ReadButtons(Script& script, const toml::Section& file, const std::string& list,
                 std::array<show::Call, show::kButtonCount>& into);
// [fades]: how faces and expressions come and go when a person calls them.
void ReadFades(Script& script, toml::Section fades);
// The keys of [keys], which call what buttons call.
void ReadKeys(Script& script, toml::Section keys);
// Each [[button]] of roles.toml: a button of a stick, and what it calls.
void ReadStickButtons(Script& script, toml::Section file);

}  // namespace kaori::authoring
