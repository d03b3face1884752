#include "appliance/programs/monitor/levels.h"

#include <algorithm>
#include <bitset>

#include "appliance/programs/monitor/palette.h"

namespace kaori::monitor {
namespace {

using board::LevelOwner;

// Of people: blanks instead of the files' underscores, and a mix by what it is of.
std::string NameOf(show::Level level, const show::Show& show) {
  if (show::IsMix(level)) {
    const auto mix = static_cast<std::size_t>(level) - show::kNamedLevels;
    if (mix >= show.roles.mixes.size()) return std::string(show::InfoOf(level).name);
    const show::Call& of = show.roles.mixes[mix];
    const bool face = of.kind == show::CallKind::kFace;
    if (face) return of.index < show.cast.faces.size() ? show.cast.faces[of.index].name : "";
    return of.index < show.cast.expressions.size() ? show.cast.expressions[of.index].name : "";
  }
  std::string name(show::InfoOf(level).name);
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::string OwnerName(const board::LevelShown& level, const show::Roles& roles) {
  switch (level.owner) {
    case LevelOwner::kNobody:
      return {};
    case LevelOwner::kCue:
      return "cue";
    case LevelOwner::kRemote:
      return "remote";
    case LevelOwner::kLips:
      return "lips";
    case LevelOwner::kVoice:
      return "voice";
    case LevelOwner::kRole:
      break;
  }
  return level.role < roles.roles.size() ? roles.roles[level.role].name : "taught";
}

std::bitset<show::kLevelCount> PlayedBy(const show::Roles& roles) {
  std::bitset<show::kLevelCount> played;
  for (const show::Role& role : roles.roles)
    for (const show::RoleMap& map : role.maps) played.set(static_cast<std::size_t>(map.level));
  return played;
}

}  // namespace

image::Colour ColourOf(LevelOwner owner, std::uint32_t role) {
  switch (owner) {
    case LevelOwner::kNobody:
      return kQuiet;
    case LevelOwner::kCue:
      return kByCue;
    case LevelOwner::kRemote:
      return kByRemote;
    case LevelOwner::kLips:
      return kByLips;
    case LevelOwner::kVoice:
      return kByVoice;
    case LevelOwner::kRole:
      break;
  }
  return kByRole[role % kByRole.size()];
}

std::vector<Level> LevelsOf(const Moment& moment) {
  const auto played = PlayedBy(moment.show.roles);
  std::vector<Level> levels;
  for (std::size_t i = 0; i < show::kLevelCount; ++i) {
    const board::LevelShown& level = moment.show_now.value.levels[i];
    if (!played[i] && level.owner == LevelOwner::kNobody) continue;
    const show::LevelInfo& info = show::kLevels[i];
    const auto share = [&](float value) {
      return std::clamp((value - info.low) / (info.high - info.low), 0.0F, 1.0F);
    };
    levels.push_back({NameOf(static_cast<show::Level>(i), moment.show), OwnerName(level, moment.show.roles),
                      ColourOf(level.owner, level.role), share(level.value), share(info.rest)});
  }
  return levels;
}

std::vector<Tag> RolesOf(const Moment& moment) {
  const auto& roles = moment.show.roles.roles;
  std::vector<Tag> tags;
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const std::size_t device = moment.show_now.value.role_devices[i];
    const bool is_played = device < show::kDeviceCount;
    tags.push_back({roles[i].name + (is_played ? ": " + std::string(show::kDeviceNames[device]) : ": nobody"),
                    is_played ? ColourOf(LevelOwner::kRole, static_cast<std::uint32_t>(i)) : kQuiet});
  }
  return tags;
}

}  // namespace kaori::monitor
