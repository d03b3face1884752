#include "appliance/core/roles/roles_file.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/roles/map_reader.h"
#include "appliance/core/roles/named.h"
#include "appliance/core/toml/nearest.h"
#include "appliance/core/toml/section.h"
#include "drivers/base/read_file.h"

namespace kaori::roles {
namespace {

using show::RoleMap;

// A role as a file has it: a device that is not given is not the first one.
struct WrittenRole {
  show::Role role;
  bool has_device = false;
  std::vector<show::Level> freed{};  // Of an overlay: levels that the role below is to move no more.
};

// Whether a map of an overlay says that nothing of the role moves its level.
bool IsNone(const toml::Section& map) {
  const toml::Value* const control = map.Find("control");
  return control != nullptr && control->kind == toml::Value::Kind::kText && control->text == kNoControl;
}

void ReadFreed(toml::Section& map, LevelReader& levels, WrittenRole& written) {
  map.AllowOnly({"control", "level"});
  if (const auto level = levels.Read(map)) written.freed.push_back(*level);
}

// An overlay may leave the device out. Maps are put into the order of their levels, which keeps those of one
// level together as CheckRoles wants them; those of one level keep their order.
WrittenRole ReadRole(toml::Section section, LevelReader& levels, bool overlay) {
  section.AllowOnly({"name", "device", "map"});
  WrittenRole written;
  written.role.name = section.Text("name");
  std::optional<show::Device> device;
  written.has_device = section.Has("device");
  if (written.has_device || !overlay)
    if (const auto found = IndexOf(section, "device", section.Text("device"), show::kDeviceNames))
      device = static_cast<show::Device>(*found);
  written.role.device = device.value_or(show::Device::kLeftStick);
  for (toml::Section map : section.Parts("map")) {
    if (overlay && IsNone(map))
      ReadFreed(map, levels, written);
    else
      written.role.maps.push_back(MapReader(map, device, levels).Read());
  }
  std::ranges::stable_sort(written.role.maps, {}, &RoleMap::level);
  return written;
}

// A [[role]] by its own name: faults call it "role "head"" rather than "role[2]".
toml::Section Named(const toml::Section& section, std::size_t number, toml::Faults& faults) {
  const toml::Value* name = section.Find("name");
  const bool named = name != nullptr && name->kind == toml::Value::Kind::kText && !name->text.empty();
  return {section.table(), named ? fmt::format("role \"{}\"", name->text) : fmt::format("role[{}]", number),
          faults};
}

// Of this file alone; what an overlay and the roles below it have together is counted by CheckRoles.
void CheckCounts(toml::Section& file, const std::vector<WrittenRole>& roles) {
  std::size_t maps = 0;
  for (const WrittenRole& one : roles) maps += one.role.maps.size();
  if (roles.size() > show::kMostRoles)
    file.Fault("role", fmt::format("there are {}, and {} is the most", roles.size(), show::kMostRoles));
  if (maps > show::kMostRoleMaps)
    file.Fault("role", fmt::format("they have {} maps, and {} is the most", maps, show::kMostRoleMaps));
}

// An overlay's role that the roles below have not is one of its own where it names a device, and else a name
// that was mistaken. With a device a name that is near to one below may be mistaken all the same: a warning.
void CheckName(toml::Section& role, const WrittenRole& written, const show::Roles& below,
               toml::Faults& warnings) {
  const std::string& name = written.role.name;
  if (name.empty() || std::ranges::find(below.roles, name, &show::Role::name) != below.roles.end()) return;
  const std::string near = toml::DidYouMeanOneOf(name, below.roles);
  if (!written.has_device)
    return role.Fault(
        "name", fmt::format("the show has no role \"{}\", and a further one needs a device{}", name, near));
  if (!near.empty())
    toml::Section(role.table(), fmt::format("role \"{}\"", name), warnings)
        .Fault("name", fmt::format("the show has no role \"{}\": it is a further one{}", name, near));
}

// What one file says. An overlay without a hand-over time leaves that of the show.
struct WrittenFile {
  std::vector<WrittenRole> roles;
  std::vector<show::Call> mixes{};
  std::optional<float> handover_s{};
  Besides besides{};
};

// `below`: the roles over which an overlay lies; null for the file of a show.
WrittenFile ReadAll(toml::Section file, toml::Faults& faults, const Items& items, const show::Roles* below) {
  const bool overlay = below != nullptr;
  file.AllowOnly({"handover_s", "role", "button"});
  WrittenFile written;
  if (overlay) written.mixes = below->mixes;
  LevelReader levels(items, written.mixes);
  toml::Faults warnings(faults.file());
  if (file.Has("handover_s")) {
    const double handover_s = file.Number("handover_s");
    if (!(handover_s >= 0 && handover_s <= show::kLongestHandover_s))
      file.Fault("handover_s",
                 fmt::format("is {} s, not within 0 to {}", handover_s, show::kLongestHandover_s));
    written.handover_s = static_cast<float>(handover_s);
  }
  std::size_t number = 0;
  for (const toml::Section& role : file.Parts("role")) {
    toml::Section named = Named(role, ++number, faults);
    written.roles.push_back(ReadRole(named, levels, overlay));
    if (overlay) CheckName(named, written.roles.back(), *below, warnings);
    const std::string& name = written.roles.back().role.name;
    const auto is_same = [&name](const WrittenRole& one) { return one.role.name == name; };
    if (!name.empty() && std::ranges::count_if(written.roles, is_same) > 1)
      named.Fault("name", fmt::format("the name \"{}\" is given twice", name));
  }
  if (number == 0 && !overlay && !file.Has("button"))
    file.Fault("role", "there is none; without this file sticks and dials play what they usually do");
  CheckCounts(file, written.roles);
  if (!overlay) return written;
  for (toml::Section button : file.Parts("button")) ReadButton(button, items, written.besides.buttons);
  written.besides.warnings = warnings.lines();
  return written;
}

}  // namespace

std::vector<std::string> ReadRolesFile(const std::filesystem::path& file, const Items& items,
                                       show::Roles& roles) {
  const auto value = toml::ReadToml(file);
  if (!value) return {value.error().message()};
  toml::Faults faults(file.string());
  WrittenFile written = ReadAll(toml::Section(*value, "", faults), faults, items, nullptr);
  if (written.roles.empty()) {
    roles.handover_s = written.handover_s.value_or(roles.handover_s);
    return faults.lines();
  }
  roles = {.handover_s = written.handover_s.value_or(show::Roles().handover_s),
           .roles = {},
           .mixes = std::move(written.mixes)};
  for (WrittenRole& one : written.roles) roles.roles.push_back(std::move(one.role));
  return faults.lines();
}

// Level by level: on a level that a role of the overlay moves, its maps take the place of that role's
// maps below. The sum of both is checked before it becomes `roles`, since two files that are right
// can be too much together.
std::vector<std::string> LayOverText(std::string_view text, const std::string& file, const Items& items,
                                     show::Roles& roles, Besides& besides) {
  const auto value = toml::Parse(text, file);
  if (!value) return {value.error().message()};
  toml::Faults faults(file);
  WrittenFile written = ReadAll(toml::Section(*value, "", faults), faults, items, &roles);
  if (faults.any()) return faults.lines();
  show::Roles laid = roles;
  laid.handover_s = written.handover_s.value_or(laid.handover_s);
  laid.mixes = std::move(written.mixes);
  for (WrittenRole& one : written.roles) {
    const auto below = std::ranges::find(laid.roles, one.role.name, &show::Role::name);
    if (below == laid.roles.end()) {
      laid.roles.push_back(std::move(one.role));
      continue;
    }
    if (one.has_device) below->device = one.role.device;
    std::erase_if(below->maps, [&one](const RoleMap& map) {
      return std::ranges::find(one.role.maps, map.level, &RoleMap::level) != one.role.maps.end() ||
             std::ranges::find(one.freed, map.level) != one.freed.end();
    });
    std::ranges::move(one.role.maps, std::back_inserter(below->maps));
    std::ranges::stable_sort(below->maps, {}, &RoleMap::level);
  }
  std::vector<std::string> wrong;
  show::CheckRoles(laid, wrong);
  for (std::string& line : wrong) line = fmt::format("{}: {}", file, line);
  if (!wrong.empty()) return wrong;
  roles = std::move(laid);
  besides = std::move(written.besides);
  return {};
}

std::vector<std::string> LayOver(const std::filesystem::path& file, const Items& items, show::Roles& roles,
                                 Besides& besides) {
  const auto text = ReadFile(file);
  if (!text) return {text.error().message()};
  return LayOverText(*text, file.string(), items, roles, besides);
}

}  // namespace kaori::roles
