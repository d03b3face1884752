#include "appliance/core/roles/level_names.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "appliance/core/roles/named.h"
#include "appliance/core/toml/nearest.h"

namespace kaori::roles {
namespace {

constexpr std::string_view kFaceLevel = "face ", kExpressionLevel = "expression ";

constexpr auto LevelNames() {
  std::array<std::string_view, show::kNamedLevels> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = show::kLevels[i].name;
  return names;
}

}  // namespace

Items ItemsOf(const face::Cast& cast) {
  Items items;
  for (const face::Face& one : cast.faces) items.faces.push_back(one.name);
  for (const face::Expression& one : cast.expressions) items.expressions.push_back(one.name);
  return items;
}

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
