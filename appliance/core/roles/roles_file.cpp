#include "appliance/core/roles/roles_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/roles/named.h"
#include "appliance/core/toml/section.h"

namespace kaori::roles {
namespace {

using show::Control;
using show::InfoOf;
using show::RoleMap;

// A role as a file has it: a device that is not given is not the first one.
struct WrittenRole {
  show::Role role;
  bool has_device = false;
};

// One [[role.map]].
// What is wrong becomes a fault of the section and reads as a default, so that all faults of
// a file are told at once.
class MapReader {
 public:
  MapReader(toml::Section& section, std::optional<show::Device> device, LevelReader& levels)
      : section_(section), device_(device), levels_(levels) {}

  // The control is read first: whether it turns decides between per_turn and range.
  RoleMap Read() {
    section_.AllowOnly({"control", "level", "range", "per_turn", "dead", "curve", "takeover"});
    ReadControl();
    if (const auto level = levels_.Read(section_)) {
      map_.level = *level;
      show::Turns(map_.control) ? ReadTurn() : ReadRange();
    }
    map_.dead = section_.FloatOr("dead", 0, 0, show::kMostDead);
    ReadCurve();
    if (section_.Has("takeover")) ReadTakeover();
    return std::move(map_);
  }

 private:
  // Where an overlay names no device the control's name alone is judged; LayOver has the
  // whole role checked later.
  void ReadControl() {
    const std::string name = section_.Text("control");
    if (name.empty()) return;
    const auto control = show::ControlNamed(name);
    if (!control)
      return section_.Fault(
          "control", fmt::format("there is no control \"{}\"; controls are x, y, twist, hat x, hat y, slider "
                                 "of a stick, and dial 1 to dial 8",
                                 name));
    map_.control = control->control;
    map_.dial = control->dial;
    if (device_ && !show::Has(*device_, map_.control))
      section_.Fault("control", fmt::format("the {} has no {}",
                                            show::kDeviceNames[static_cast<std::size_t>(*device_)], name));
  }

  // Within the level's ends, in its own unit; both ends may be swapped.
  void ReadRange() {
    const show::LevelInfo& level = InfoOf(map_.level);
    map_.from = level.low;
    map_.to = level.high;
    if (section_.Has("per_turn")) section_.Fault("per_turn", "is for dials; a control with ends has a range");
    if (!section_.Has("range")) return;
    const std::vector<double> range = section_.Numbers("range");
    if (range.size() != 2 || range[0] == range[1])
      return section_.Fault("range", "must be two different numbers [at the one end, at the other]");
    map_.from = Inside("range", range[0]);
    map_.to = Inside("range", range[1]);
  }

  // From the file's unit to the level's own. A ten-thousandth of the range is forgiven, as rounded
  // degrees need, and then cut off.
  float Inside(std::string_view key, double written) {
    const show::LevelInfo& level = InfoOf(map_.level);
    const double low = level.low / level.unit, high = level.high / level.unit, slack = (high - low) * 1e-4;
    if (!(written >= low - slack && written <= high + slack))
      section_.Fault(key, fmt::format("{} is not within {:.4g} to {:.4g}{}{} of {}", written, low, high,
                                      level.words.empty() ? "" : " ", level.words, level.name));
    return std::clamp(static_cast<float>(written * level.unit), level.low, level.high);
  }

  // One turn adds the whole range where nothing is said, and a hundred times that at most.
  // Below 0 the dial is inverted.
  void ReadTurn() {
    const show::LevelInfo& level = InfoOf(map_.level);
    if (section_.Has("range")) section_.Fault("range", "is for controls with ends; a dial has per_turn");
    const float whole = (level.high - level.low) / level.unit;
    const float turn = section_.FloatOr("per_turn", whole, -100 * whole, 100 * whole);
    if (turn == 0) section_.Fault("per_turn", "is 0: the dial would do nothing");
    map_.to = turn * level.unit;
  }

  // A number is an exponent, a list holds points. A point that is no pair ends the list,
  // since it cannot be one curve.
  void ReadCurve() {
    const toml::Value* curve = section_.Find("curve");
    if (curve == nullptr) return;
    if (curve->kind == toml::Value::Kind::kNumber) {
      map_.exponent = section_.FloatOr("curve", 1, show::kFlattestCurve, show::kSteepestCurve);
      return;
    }
    if (curve->kind != toml::Value::Kind::kList)
      return section_.Fault("curve", "must be an exponent, or points [[0, 0], [0.5, 0.3], [1, 1]]");
    for (const toml::Value& point : curve->list) {
      if (point.kind != toml::Value::Kind::kList || point.list.size() != 2 ||
          point.list[0].kind != toml::Value::Kind::kNumber ||
          point.list[1].kind != toml::Value::Kind::kNumber)
        return section_.Fault("curve", "each of its points must be two numbers");
      map_.points.emplace_back(point.list[0].number, point.list[1].number);
    }
    if (!show::IsCurve(map_.points))
      section_.Fault("curve", fmt::format("must be 2 to {} points that rise from [0, 0] to [1, 1]",
                                          show::kMostCurvePoints));
  }

  // A spring always comes from its middle and a dial only turns: neither has a place from which it would
  // leap.
  void ReadTakeover() {
    const auto takeover = IndexOf(section_, "takeover", section_.Text("takeover"), show::kTakeoverNames);
    if (takeover) map_.takeover = static_cast<show::Takeover>(*takeover);
    if (!show::StaysPut(map_.control))
      section_.Fault("takeover", "is for controls that stay where they are put: the slider of a stick");
  }

  toml::Section& section_;
  std::optional<show::Device> device_;
  LevelReader& levels_;
  RoleMap map_;
};

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
  for (toml::Section map : section.Parts("map"))
    written.role.maps.push_back(MapReader(map, device, levels).Read());
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

// What one file says. An overlay without a hand-over time leaves that of the show.
struct WrittenFile {
  std::vector<WrittenRole> roles;
  std::vector<show::Call> mixes{};
  std::optional<float> handover_s{};
};

// `below`: the roles over which an overlay lies; null for the file of a show.
WrittenFile ReadAll(toml::Section file, toml::Faults& faults, const Items& items, const show::Roles* below) {
  const bool overlay = below != nullptr;
  file.AllowOnly({"handover_s", "role"});
  WrittenFile written;
  if (overlay) written.mixes = below->mixes;
  LevelReader levels(items, written.mixes);
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
    const std::string& name = written.roles.back().role.name;
    const auto is_same = [&name](const WrittenRole& one) { return one.role.name == name; };
    if (!name.empty() && std::ranges::count_if(written.roles, is_same) > 1)
      named.Fault("name", fmt::format("the name \"{}\" is given twice", name));
  }
  if (number == 0 && !overlay)
    file.Fault("role", "there is none; without this file sticks and dials play what they usually do");
  CheckCounts(file, written.roles);
  return written;
}

}  // namespace

std::vector<std::string> ReadRolesFile(const std::filesystem::path& file, const Items& items,
                                       show::Roles& roles) {
  const auto value = toml::ReadToml(file);
  if (!value) return {value.error().message()};
  toml::Faults faults(file.string());
  WrittenFile written = ReadAll(toml::Section(*value, "", faults), faults, items, nullptr);
  roles = {.handover_s = written.handover_s.value_or(show::Roles().handover_s),
           .roles = {},
           .mixes = std::move(written.mixes)};
  for (WrittenRole& one : written.roles) roles.roles.push_back(std::move(one.role));
  return faults.lines();
}

// Level by level: on a level that a role of the overlay moves, its maps take the place of that role's
// maps below. The sum of both is checked before it becomes `roles`, since two files that are right
// can be too much together.
std::vector<std::string> LayOver(const std::filesystem::path& file, const Items& items, show::Roles& roles) {
  const auto value = toml::ReadToml(file);
  if (!value) return {value.error().message()};
  toml::Faults faults(file.string());
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
      return std::ranges::find(one.role.maps, map.level, &RoleMap::level) != one.role.maps.end();
    });
    std::ranges::move(one.role.maps, std::back_inserter(below->maps));
    std::ranges::stable_sort(below->maps, {}, &RoleMap::level);
  }
  std::vector<std::string> wrong;
  show::CheckRoles(laid, wrong);
  for (std::string& line : wrong) line = fmt::format("{}: {}", file.string(), line);
  if (wrong.empty()) roles = std::move(laid);
  return wrong;
}

}  // namespace kaori::roles
