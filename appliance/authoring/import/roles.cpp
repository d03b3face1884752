#include "appliance/authoring/import/roles.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "appliance/authoring/import/role_table.h"

namespace kaori::import {
namespace {

using enum NameStyle;
// Styles from the one that says most of a face to the one that says least.
constexpr std::array kInOrder{kArkit, kViseme, kVrm1, kVrm0, kPlain};

// Letters and digits alone, in small letters: what names are compared by.
std::string Letters(std::string_view name) {
  std::string letters;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

// "eyeBlink_L", "eyeBlink.R", "EyeBlinkL": the side as a letter at the end, after a separator or a small
// letter. "jawL" is a side; "VISEME_OL" is none, since a capital stands before it.
std::string WithSideSpelled(std::string_view name) {
  // "L" and "_R" say a side of nothing.
  if (name.size() < 3) return Letters(name);
  const char side = name.back();
  const char before = name[name.size() - 2];
  const bool apart = before == '_' || before == '.' || before == '-' || before == ' ';
  const bool stands_out =
      apart || (std::islower(static_cast<unsigned char>(before)) != 0 && (side == 'L' || side == 'R'));
  if (!stands_out) return Letters(name);
  const std::string stem = Letters(name.substr(0, name.size() - 1));
  if (side == 'L' || side == 'l') return stem + "left";
  if (side == 'R' || side == 'r') return stem + "right";
  return Letters(name);
}

// "Face.M_F00|blendShape1.jawOpen" and "head:jawOpen" are named by what stands last; ".L" is a side, no name,
// so the last two letters are not looked at.
std::string_view LastPart(std::string_view name) {
  constexpr std::size_t kSide = 2;
  const std::string_view stem = name.size() > kSide ? name.substr(0, name.size() - kSide) : name;
  const auto at = stem.find_last_of(".:|/");
  return at == std::string_view::npos ? name : name.substr(at + 1);
}

// Other words for the plain style, with sides spelled and without separators.
std::string PlainWord(const std::string& word) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 16> kWords{
      {{"eyeclosedleft", "blinkleft"},
       {"eyeclosedright", "blinkright"},
       {"eyecloseleft", "blinkleft"},
       {"eyecloseright", "blinkright"},
       {"eyesclosed", "blink"},
       {"winkleft", "blinkleft"},
       {"winkright", "blinkright"},
       {"browraiseleft", "browupleft"},
       {"browraiseright", "browupright"},
       {"browsup", "browup"},
       {"browsdown", "browdown"},
       {"jawdrop", "jawopen"},
       {"openmouth", "mouthopen"},
       {"mouthsmile", "smile"},
       {"mouthsmileleft", "smileleft"},
       {"surprise", "surprised"}}};
  const auto same = std::ranges::find(kWords, word, &std::pair<std::string_view, std::string_view>::first);
  return same == kWords.end() ? word : std::string(same->second);
}

// VRM's words are for its presets, all others for targets.
bool Allowed(NameStyle style, NameOrigin origin) {
  const bool preset_style = style == kVrm0 || style == kVrm1;
  return origin == NameOrigin::kPreset ? preset_style : !preset_style;
}

// Both sides are compared without case and separators: "eye_blink_left" is ARKit's eyeBlinkLeft.
std::optional<Meaning> Find(NameStyle style, const std::string& letters) {
  for (const std::string_view name : NamesOf(style))
    if (Letters(name) == letters) return Meaning{style, std::string(name)};
  return std::nullopt;
}

// Makes a role of the first style that can. Borrows the meanings.
class Maker {
 public:
  explicit Maker(const std::vector<std::optional<Meaning>>& meanings) : meanings_(meanings) {}

  std::optional<Role> Make(std::string_view name) const {
    for (const NameStyle style : kInOrder)
      if (auto role = Make(name, style)) return role;
    return std::nullopt;
  }

 private:
  // The first shape of that meaning: a file may have two, as a target and in a preset.
  std::optional<std::size_t> Shape(NameStyle style, std::string_view name) const {
    for (std::size_t i = 0; i < meanings_.size(); ++i)
      if (meanings_[i] && meanings_[i]->style == style && meanings_[i]->name == name) return i;
    return std::nullopt;
  }

  // Goes through the whole table: it has about a hundred lines.
  std::optional<Role> Make(std::string_view name, NameStyle style) const {
    Role role{std::string(name), style, {}};
    bool has_first = false;
    bool first = true;
    for (const RoleEntry& entry : RoleTable()) {
      if (entry.role != name || entry.style != style) continue;
      const auto shape = Shape(style, entry.shape);
      if (shape) role.parts.push_back({*shape, entry.weight});
      has_first = has_first || (first && shape);
      // In the plain style entries are other words for one thing.
      if (shape && style == kPlain) return role;
      first = false;
    }
    return has_first ? std::optional(role) : std::nullopt;
  }

  const std::vector<std::optional<Meaning>>& meanings_;
};

}  // namespace

std::string_view NameOf(NameStyle style) {
  switch (style) {
    case kArkit:
      return "ARKit";
    case kVrm1:
      return "VRM 1.0";
    case kVrm0:
      return "VRM 0.x";
    case kViseme:
      return "viseme";
    case kPlain:
      return "plain";
  }
  return "";
}

// Styles in their order; a preset's name counts whole, a target's by its last part.
std::optional<Meaning> MeaningOf(std::string_view name, NameOrigin origin) {
  const std::string letters = WithSideSpelled(LastPart(name));
  for (const NameStyle style : kInOrder) {
    if (!Allowed(style, origin)) continue;
    // Presets are spelled in one way: "blink_l" is VRM 0.x, "blinkLeft" is VRM 1.0.
    if (auto found = Find(style, origin == NameOrigin::kPreset ? Letters(name) : letters)) return found;
  }
  // The last resort, behind all styles' own words.
  return origin == NameOrigin::kTarget ? Find(kPlain, PlainWord(letters)) : std::nullopt;
}

// Each once, in the order in which the table first names it.
std::vector<std::string> KnownRoles() {
  std::vector<std::string> names;
  for (const RoleEntry& entry : RoleTable())
    if (std::ranges::find(names, entry.role) == names.end()) names.emplace_back(entry.role);
  return names;
}

// In the order of KnownRoles; a role of which no style can make anything is left out.
std::vector<Role> FindRoles(const std::vector<std::optional<Meaning>>& meanings) {
  std::vector<Role> roles;
  const Maker maker(meanings);
  for (const std::string& name : KnownRoles())
    if (auto role = maker.Make(name)) roles.push_back(std::move(*role));
  return roles;
}

// Only whole entries mean the role: a jaw that is 0.7 of an "a" is no "a".
const Target* FindTarget(const Model& model, std::string_view role) {
  for (const Target& target : model.targets) {
    const auto meaning = MeaningOf(target.name, NameOrigin::kTarget);
    if (!meaning) continue;
    for (const RoleEntry& entry : RoleTable())
      if (entry.role == role && entry.style == meaning->style && entry.shape == meaning->name &&
          // A shape that only helps in a role does not mean it.
          entry.weight == 1)
        return &target;
  }
  return nullptr;
}

}  // namespace kaori::import
