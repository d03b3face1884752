#include "appliance/core/roles/level_names.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "appliance/core/roles/named.h"
#include "appliance/core/toml/nearest.h"

namespace kaori::roles {
namespace {

// What stands before the name of a face or an expression, as in "expression angry". The blank belongs to it.
constexpr std::string_view kFaceLevel = "face ", kExpressionLevel = "expression ";

// Of the levels that every show has. Those of mixes are called by their items, and their
// own names stand in no file.
constexpr auto LevelNames() {
  std::array<std::string_view, show::kNamedLevels> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = show::kLevels[i].name;
  return names;
}

}  // namespace

// In the order of the cast, so that the place of a name is the index that a call carries.
Items ItemsOf(const face::Cast& cast) {
  Items items;
  for (const face::Face& one : cast.faces) items.faces.push_back(one.name);
  for (const face::Expression& one : cast.expressions) items.expressions.push_back(one.name);
  return items;
}

// A show without a list of its own has its scenes as cues, which are called as scenes.
Items ItemsOf(const show::Show& show) {
  Items items = ItemsOf(show.cast);
  for (const show::Motion& motion : show.motions) items.motions.push_back(motion.name);
  for (const show::StageScene& scene : show.scenes) items.scenes.push_back(scene.name);
  if (!show.cue_list.of_scenes)
    for (const show::Cue& cue : show.cue_list.cues) items.cues.push_back(cue.number);
  return items;
}

// A name that begins with "face " or "expression " is looked up among the show's items, any other among
// the levels. Where the cast could not be read whole an item that is not found is no fault: it may be
// in the file that has one.
std::optional<show::Level> LevelReader::Read(toml::Section& section) {
  const std::string name = section.Text("level");
  const bool face = name.starts_with(kFaceLevel);
  if (!face && !name.starts_with(kExpressionLevel)) {
    const auto level = IndexOf(section, "level", name, LevelNames());
    return level ? std::optional(static_cast<show::Level>(*level)) : std::nullopt;
  }
  const std::string item = name.substr(face ? kFaceLevel.size() : kExpressionLevel.size());
  const auto& names = face ? items_.faces : items_.expressions;
  const auto found = std::ranges::find(names, item);
  if (found != names.end())
    return MixOf(section, {face ? show::CallKind::kFace : show::CallKind::kExpression,
                           static_cast<std::uint16_t>(found - names.begin())});
  if (items_.all_known)
    section.Fault("level", fmt::format("there is no {} \"{}\"{}", face ? "face" : "expression", item,
                                       toml::DidYouMean(item, {names.begin(), names.end()})));
  return std::nullopt;
}

// Each item is in the list once, and its place there says which level it has: two maps of one item move the
// same level. More items than there are such levels are a fault of the map that comes too late.
std::optional<show::Level> LevelReader::MixOf(toml::Section& section, const show::Call& item) {
  const auto same = [&](const show::Call& mix) { return mix.kind == item.kind && mix.index == item.index; };
  const auto known = std::ranges::find_if(mixes_, same);
  if (known != mixes_.end()) return show::MixLevel(static_cast<std::size_t>(known - mixes_.begin()));
  if (mixes_.size() == show::kMixCount) {
    section.Fault("level", fmt::format("is one face or expression more than the {} that roles may play",
                                       show::kMixCount));
    return std::nullopt;
  }
  mixes_.push_back(item);
  return show::MixLevel(mixes_.size() - 1);
}

// Any level and any roles may be asked for: what they do not have is called "nothing", so that
// two shows can be compared.
std::string LevelName(const show::Roles& roles, show::Level level, const Items& items) {
  if (!show::IsMix(level)) return std::string(InfoOf(level).name);
  const std::size_t mix = static_cast<std::size_t>(level) - show::kNamedLevels;
  if (mix >= roles.mixes.size()) return "nothing";
  const bool face = roles.mixes[mix].kind == show::CallKind::kFace;
  const auto& names = face ? items.faces : items.expressions;
  const std::size_t index = roles.mixes[mix].index;
  return fmt::format("{}{}", face ? kFaceLevel : kExpressionLevel,
                     index < names.size() ? names[index] : "nothing");
}

}  // namespace kaori::roles
