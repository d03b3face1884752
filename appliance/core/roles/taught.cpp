#include "appliance/core/roles/taught.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/roles/roles_file.h"
#include "appliance/core/toml/quoted.h"
#include "appliance/core/toml/value.h"

namespace kaori::roles {
namespace {

using show::Role;
using show::RoleMap;

constexpr std::string_view kHead =
    "# The box's own roles, over those of the show. What is taught on the box is added here.\n";

std::string_view Trimmed(std::string_view line) {
  const auto begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
}

bool SaysNothing(std::string_view line) {
  const std::string_view said = Trimmed(line);
  return said.empty() || said.front() == '#';
}

bool IsText(const toml::Value* value, std::string_view text) {
  return value != nullptr && value->kind == toml::Value::Kind::kText && value->text == text;
}

// The tables of a list, in the order of the file; none where there is no such list.
std::vector<const toml::Value*> TablesOf(const toml::Value& table, std::string_view key) {
  std::vector<const toml::Value*> tables;
  if (const toml::Value* list = toml::Find(table, key))
    for (const toml::Value& one : list->list) tables.push_back(&one);
  return tables;
}

// A file's lines, into which maps are written. Lines count from 0 here, and from 1 in toml::Value.
class RolesLines {
 public:
  RolesLines(std::string_view text, std::string file) : file_(std::move(file)) {
    while (!text.empty()) {
      const auto end = std::min(text.find('\n'), text.size());
      lines_.emplace_back(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  std::string text() const { return fmt::format("{}\n", fmt::join(lines_, "\n")); }

  // Of this role `maps`, texts of [[role.map]], are all that is said of the level. `device` is written where
  // the file has no such role yet; none: the role has that of the file below.
  Result<void> Set(const std::string& role, std::optional<show::Device> device, const std::string& level,
                   const std::vector<std::string>& maps) {
    const auto value = toml::Parse(text(), file_);
    if (!value) return tl::unexpected(value.error());
    const auto roles = TablesOf(*value, "role");
    const auto found = std::ranges::find_if(
        roles, [&](const toml::Value* one) { return IsText(toml::Find(*one, "name"), role); });
    if (found == roles.end()) {
      if (!maps.empty()) AddRole(role, device, maps);
      *this = RolesLines(text(), file_);
      return {};
    }
    const auto next = std::next(found);
    std::size_t end = next == roles.end() ? lines_.size() : LineOf(**next);
    if (!IsHeader(LineOf(**found), "[[role]]") || (next != roles.end() && !IsHeader(end, "[[role]]")))
      return FailForm();
    if (auto removed = Remove(**found, level, end); !removed) return removed;
    AddMaps(end, maps);
    *this = RolesLines(text(), file_);  // What was added is lines too.
    return {};
  }

 private:
  static std::size_t LineOf(const toml::Value& table) { return static_cast<std::size_t>(table.line - 1); }
  bool IsHeader(std::size_t line, std::string_view header) const {
    return line < lines_.size() && Trimmed(lines_[line]).starts_with(header);
  }
  tl::unexpected<Error> FailForm() const {
    return FailInput(
        fmt::format("{}: its roles are not tables of their own, [[role]] and [[role.map]]: "
                    "nothing can be added to them",
                    file_));
  }

  // From the last to the first, so that lines before keep their numbers. `end` is that of the role.
  Result<void> Remove(const toml::Value& role, const std::string& level, std::size_t& end) {
    const auto maps = TablesOf(role, "map");
    for (std::size_t i = maps.size(); i-- > 0;) {
      if (!IsText(toml::Find(*maps[i], "level"), level)) continue;
      std::size_t first = LineOf(*maps[i]);
      if (!IsHeader(first, "[[role.map]]")) return FailForm();
      std::size_t last = i + 1 < maps.size() ? LineOf(*maps[i + 1]) : end;
      while (SaysNothing(lines_[last - 1])) --last;
      if (Trimmed(lines_[first - 1]).empty()) --first;  // The role's header stands before it.
      Erase(first, last);
      end -= last - first;
    }
    return {};
  }

  void Erase(std::size_t first, std::size_t last) {
    lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(first),
                 lines_.begin() + static_cast<std::ptrdiff_t>(last));
  }

  // Behind the last line of the role that says something: a comment that follows is of the next role.
  void AddMaps(std::size_t end, const std::vector<std::string>& maps) {
    while (end > 0 && SaysNothing(lines_[end - 1])) --end;
    std::vector<std::string> added;
    for (const std::string& map : maps) {
      added.emplace_back();
      added.push_back(map.substr(0, map.find_last_not_of('\n') + 1));
    }
    lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(end), added.begin(), added.end());
  }

  void AddRole(const std::string& role, std::optional<show::Device> device,
               const std::vector<std::string>& maps) {
    lines_.push_back(fmt::format("\n[[role]]\nname = {}", toml::Quoted(role)));
    if (device)
      lines_.back() +=
          fmt::format("\ndevice = \"{}\"", show::kDeviceNames[static_cast<std::size_t>(*device)]);
    AddMaps(lines_.size(), maps);
  }

  std::string file_;
  std::vector<std::string> lines_;
};

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
                         const show::Roles& below) {
  show::Roles laid = below;
  const auto faults = LayOverText(text, file, items, laid);
  if (!faults.empty()) return FailInput(fmt::format("{}", fmt::join(faults, "; ")));
  return laid;
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
    return lines.Set(target_, is_new ? std::optional(taught_.device) : std::nullopt, taught_.level,
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
      if (auto set = lines.Set(role.name, std::nullopt, level, left); !set) return set;
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
  const auto laid = Laid(text, file, items, below);
  if (!laid) return tl::unexpected(laid.error());
  const Lesson lesson(items, below, *laid, taught);
  RolesLines lines(text.empty() ? kHead : std::string_view(text), file);
  if (auto written = lesson.WriteTo(lines); !written) return tl::unexpected(written.error());
  std::string with = lines.text();
  const auto again = Laid(with, file, items, below);
  if (!again) return tl::unexpected(again.error());
  if (!lesson.IsIn(*again)) return FailInput(fmt::format("{}: what was taught cannot be added to it", file));
  return with;
}

}  // namespace kaori::roles
