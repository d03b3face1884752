#include "appliance/core/roles/taught.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/roles/roles_file.h"
#include "appliance/core/roles/roles_lines.h"
#include "appliance/core/toml/quoted.h"
#include "appliance/core/toml/value.h"

namespace kaori::roles {
namespace {

using show::Role;
using show::RoleMap;

constexpr std::string_view kHead =
    "# The box's own roles, over those of the show. What is taught on the box is added here.\n";

bool IsControlOf(const RoleMap& map, const Taught& taught) {
  return map.control == taught.map.control && map.dial == taught.map.dial;
}

// As the file has them.
std::vector<RoleMap> MapsOn(const Role& role, show::Level level) {
  std::vector<RoleMap> maps;
  std::ranges::copy_if(role.maps, std::back_inserter(maps),
                       [level](const RoleMap& map) { return map.level == level; });
  return maps;
}

const Role* RoleNamed(const show::Roles& roles, std::string_view name) {
  const auto found = std::ranges::find(roles.roles, name, &Role::name);
  return found == roles.roles.end() ? nullptr : &*found;
}

// What one file says, laid over the show's roles. Errors: those of LayOverText, all of them in one line.
Result<show::Roles> Laid(const std::string& text, const std::string& file, const Items& items,
                         const show::Roles& below, Besides& besides) {
  show::Roles laid = below;
  const auto faults = LayOverText(text, file, items, laid, besides);
  if (!faults.empty()) return FailInput(fmt::format("{}", fmt::join(faults, "; ")));
  return laid;
}

tl::unexpected<Error> FailToAdd(const std::string& file) {
  return FailInput(fmt::format("{}: what was taught cannot be added to it", file));
}

// One thing that was taught, and the roles into which it goes.
class Lesson {
 public:
  Lesson(const Items& items, const show::Roles& below, const show::Roles& laid, const Taught& taught)
      : items_(items), below_(below), laid_(laid), taught_(taught), target_(TargetOf()) {}

  const std::string& target() const { return target_; }

  Result<void> WriteTo(RolesLines& lines) const {
    for (const Role& role : laid_.roles)
      if (role.device == taught_.device)
        if (auto freed = Free(role, lines); !freed) return freed;
    const bool is_new = RoleNamed(below_, target_) == nullptr;
    return lines.SetMaps(target_, is_new ? std::optional(taught_.device) : std::nullopt, taught_.level,
                         {TextOf(taught_.map, taught_.level)});
  }

  bool IsIn(const show::Roles& roles) const {
    const Role* const role = RoleNamed(roles, target_);
    return role != nullptr && std::ranges::count_if(role->maps, [&](const RoleMap& map) {
                                return IsControlOf(map, taught_) &&
                                       LevelName(roles, map.level, items_) == taught_.level;
                              }) == 1;
  }

 private:
  // The role that plays the level from this device, or one for all that is taught of it.
  std::string TargetOf() const {
    for (const Role& role : laid_.roles)
      if (role.device == taught_.device && std::ranges::any_of(role.maps, [&](const RoleMap& map) {
            return LevelName(laid_, map.level, items_) == taught_.level;
          }))
        return role.name;
    return fmt::format("taught {}", show::kDeviceNames[static_cast<std::size_t>(taught_.device)]);
  }

  // Takes the control from the other levels that it moves. A level that the show's role moves by it alone is
  // named with no control, or the show's map would stay.
  Result<void> Free(const Role& role, RolesLines& lines) const {
    for (const RoleMap& map : role.maps) {
      const std::string level = LevelName(laid_, map.level, items_);
      if (!IsControlOf(map, taught_) || level == taught_.level) continue;
      std::vector<std::string> left;
      for (const RoleMap& other : MapsOn(role, map.level))
        if (!IsControlOf(other, taught_)) left.push_back(TextOf(other, level));
      const Role* const shows = RoleNamed(below_, role.name);
      if (left.empty() && shows != nullptr && !MapsOn(*shows, map.level).empty())
        left.push_back(
            fmt::format("[[role.map]]\ncontrol = \"{}\"\nlevel = {}\n", kNoControl, toml::Quoted(level)));
      if (auto set = lines.SetMaps(role.name, std::nullopt, level, left); !set) return set;
    }
    return {};
  }

  const Items& items_;
  const show::Roles& below_;
  const show::Roles& laid_;
  const Taught& taught_;
  std::string target_;
};

}  // namespace

std::optional<RoleMap> MapOfWhole(show::Level level, const show::NamedControl& control, bool inverted) {
  const show::LevelInfo& info = show::InfoOf(level);
  RoleMap map{
      .control = control.control, .dial = control.dial, .level = level, .from = info.low, .to = info.high};
  if (show::Turns(control.control)) {
    map.from = 0;
    map.to = (info.high - info.low) * (inverted ? -1.0F : 1.0F);
    return map;
  }
  if (show::Springs(control.control)) {
    const float half = std::min(info.rest - info.low, info.high - info.rest);
    if (half <= 0) return std::nullopt;
    map.from = info.rest - half;
    map.to = info.rest + half;
  }
  if (inverted) std::swap(map.from, map.to);
  return map;
}

std::vector<std::string> OtherLevelsOf(const show::Roles& roles, const Items& items, const Taught& taught) {
  std::vector<std::string> levels;
  for (const Role& role : roles.roles)
    for (const RoleMap& map : role.maps) {
      std::string level = LevelName(roles, map.level, items);
      const bool is_other = role.device == taught.device && IsControlOf(map, taught) &&
                            level != taught.level && std::ranges::find(levels, level) == levels.end();
      if (is_other) levels.push_back(std::move(level));
    }
  return levels;
}

// The text is read back before it is given: what the lines were taken for need not be what they are.
Result<std::string> Teach(const std::string& text, const std::string& file, const Items& items,
                          const show::Roles& below, const Taught& taught) {
  Besides besides;
  const auto laid = Laid(text, file, items, below, besides);
  if (!laid) return tl::unexpected(laid.error());
  const Lesson lesson(items, below, *laid, taught);
  RolesLines lines(text.empty() ? kHead : std::string_view(text), file);
  if (auto written = lesson.WriteTo(lines); !written) return tl::unexpected(written.error());
  std::string with = lines.text();
  const auto again = Laid(with, file, items, below, besides);
  if (!again) return tl::unexpected(again.error());
  return lesson.IsIn(*again) ? Result<std::string>(std::move(with)) : FailToAdd(file);
}

Result<std::string> Teach(const std::string& text, const std::string& file, const Items& items,
                          const show::Roles& below, const TaughtButton& taught) {
  Besides besides;
  if (const auto laid = Laid(text, file, items, below, besides); !laid) return tl::unexpected(laid.error());
  RolesLines lines(text.empty() ? kHead : std::string_view(text), file);
  if (auto written = lines.SetButton(taught.button, taught.call); !written)
    return tl::unexpected(written.error());
  std::string with = lines.text();
  if (const auto again = Laid(with, file, items, below, besides); !again)
    return tl::unexpected(again.error());
  const auto is_it = [&](const OwnButton& own) {
    return own.button == taught.button && NameOf(own.call, items) == taught.call;
  };
  return std::ranges::any_of(besides.buttons, is_it) ? Result<std::string>(std::move(with)) : FailToAdd(file);
}

}  // namespace kaori::roles
