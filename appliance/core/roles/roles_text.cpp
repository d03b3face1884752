#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/roles/roles_file.h"
#include "appliance/core/toml/quoted.h"

namespace kaori::roles {

// Nine digits bring back the same float.
// Of a map nothing is written that is at its default: a line in the file is something that was meant.
std::string TextOf(const show::RoleMap& map, std::string_view level_name) {
  const show::LevelInfo& level = show::InfoOf(map.level);
  std::string text = fmt::format("[[role.map]]\ncontrol = \"{}\"\nlevel = {}\n", show::NameOf(map),
                                 toml::Quoted(level_name));
  if (show::Turns(map.control))
    text += fmt::format("per_turn = {:.9g}\n", (map.to - map.from) / level.unit);
  else if (map.from != level.low || map.to != level.high)
    text += fmt::format("range = [{:.9g}, {:.9g}]\n", map.from / level.unit, map.to / level.unit);
  if (map.dead != 0) text += fmt::format("dead = {:.9g}\n", map.dead);
  if (map.exponent != 1) text += fmt::format("curve = {:.9g}\n", map.exponent);
  if (!map.points.empty()) {
    std::vector<std::string> points;
    for (const glm::vec2& p : map.points) points.push_back(fmt::format("[{:.9g}, {:.9g}]", p.x, p.y));
    text += fmt::format("curve = [{}]\n", fmt::join(points, ", "));
  }
  if (map.takeover != show::Takeover::kJump)
    text += fmt::format("takeover = \"{}\"\n", show::kTakeoverNames[static_cast<std::size_t>(map.takeover)]);
  return text;
}

std::string TextOf(const show::Roles& roles, const Items& items) {
  std::string text = fmt::format("handover_s = {:.9g}\n", roles.handover_s);
  for (const show::Role& role : roles.roles) {
    text += fmt::format("\n[[role]]\nname = {}\ndevice = \"{}\"\n", toml::Quoted(role.name),
                        show::kDeviceNames[static_cast<std::size_t>(role.device)]);
    for (const show::RoleMap& map : role.maps) text += "\n" + TextOf(map, LevelName(roles, map.level, items));
  }
  return text;
}

}  // namespace kaori::roles
