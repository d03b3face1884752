#include "appliance/core/show/roles.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace kaori::show {
namespace {

// In the order of Control. "dial" alone names none: files say which, from 1 on.
constexpr std::array<std::string_view, kControlCount> kControlNames{"x",     "y",      "twist", "hat x",
                                                                    "hat y", "slider", "dial"};
constexpr int kDials = 8;

// The control's whole way for the level's whole range.
RoleMap Whole(Control control, Level level) {
  return {.control = control, .level = level, .from = InfoOf(level).low, .to = InfoOf(level).high};
}

// Dial n has level n, as the first eight levels stand. `per_turn` is in the level's own unit.
RoleMap OfDial(Level level, float per_turn) {
  return {
      .control = Control::kDial, .dial = static_cast<std::uint8_t>(level), .level = level, .to = per_turn};
}

// Straight between the points that lie around it.
float OnCurve(const std::vector<glm::vec2>& points, float way) {
  const auto next = std::ranges::upper_bound(points, way, {}, [](const glm::vec2& p) { return p.x; });
  if (next == points.begin()) return points.front().y;
  if (next == points.end()) return points.back().y;
  const glm::vec2 a = *(next - 1);
  return a.y + (next->y - a.y) * (way - a.x) / (next->x - a.x);
}

// One map, with its role's name and its control's before each reason.
class MapChecker {
 public:
  MapChecker(const Roles& roles, const Role& role, const RoleMap& map, std::vector<std::string>& faults)
      : roles_(roles), role_(role), map_(map), faults_(faults) {}

  void Check() {
    if (static_cast<std::size_t>(map_.control) >= kControlCount) return Fault("its control is not known");
    if (static_cast<std::size_t>(map_.level) >= kNamedLevels + std::min(roles_.mixes.size(), kMixCount))
      return Fault("its level is not known");
    if (map_.takeover > Takeover::kScale) Fault("its way to take over is not known");
    if (map_.dial >= kDials) Fault(fmt::format("there is no dial {}", map_.dial + 1));
    if (!Has(role_.device, map_.control)) Fault("its device has no such control");
    CheckRange();
    if (!(map_.dead >= 0 && map_.dead <= kMostDead)) Fault("its dead zone is not within 0 to 0.9");
    if (!(map_.exponent >= kFlattestCurve && map_.exponent <= kSteepestCurve))
      Fault("its curve is not within 0.1 to 10");
    CheckPoints();
  }

 private:
  void Fault(std::string_view reason) {
    faults_.push_back(fmt::format("role \"{}\", {}: {}", role_.name, NameOf(map_), reason));
  }

  // A turn may add more than the whole range; an end of a way lies within it.
  void CheckRange() {
    const LevelInfo& level = InfoOf(map_.level);
    const float span = level.high - level.low;
    const float slack = 1e-4F * span;  // Degrees of a file are not radians to the last bit.
    const auto within = [&](float value) {
      return Turns(map_.control) ? std::abs(value) <= 100 * span
                                 : value >= level.low - slack && value <= level.high + slack;
    };
    if (!within(map_.from) || !within(map_.to) || map_.from == map_.to)
      Fault("its range is none of its level");
  }

  void CheckPoints() {
    if (!map_.points.empty() && !IsCurve(map_.points))
      Fault(fmt::format("its curve is not of 2 to {} points that rise from [0, 0] to [1, 1]",
                        kMostCurvePoints));
  }

  const Roles& roles_;
  const Role& role_;
  const RoleMap& map_;
  std::vector<std::string>& faults_;
};

}  // namespace

// Full turns are those of the play of 1993: one for each whole range, but for the fade, of which one is 2 s.
// The right slider only raises the brows: where it rests they are level, and not in a frown.
Roles UsualRoles() {
  Role levels{.name = "levels", .device = Device::kDialBox, .maps = {}};
  for (std::size_t i = 0; i < kStayingLevels; ++i) {
    const auto level = static_cast<Level>(i);
    levels.maps.push_back(OfDial(level, level == Level::kFade ? 2.0F : 1.0F));
  }
  Role head{.name = "head",
            .device = Device::kLeftStick,
            .maps = {Whole(Control::kX, Level::kHeadYaw), Whole(Control::kY, Level::kHeadPitch),
                     Whole(Control::kTwist, Level::kHeadRoll), Whole(Control::kSlider, Level::kHeadLean)}};
  RoleMap brow = Whole(Control::kSlider, Level::kBrow);
  brow.from = 0;
  Role gaze{.name = "gaze",
            .device = Device::kRightStick,
            .maps = {Whole(Control::kX, Level::kGazeYaw), Whole(Control::kY, Level::kGazePitch),
                     Whole(Control::kTwist, Level::kBrow), Whole(Control::kHatY, Level::kBrow), brow}};
  return {.roles = {std::move(levels), std::move(head), std::move(gaze)}};
}

// Behind the dead zone the way begins at 0, so that nothing leaps there, and its end stays the end.
float Shaped(const RoleMap& map, float way) {
  if (map.dead == 0 && map.exponent == 1 && map.points.empty()) return way;
  const float behind = (std::abs(way) - map.dead) / (1 - map.dead);
  if (behind <= 0) return 0;
  const float shaped = map.points.empty() ? std::pow(behind, map.exponent) : OnCurve(map.points, behind);
  return std::copysign(shaped, way);
}

// A spring's middle is the middle of the range.
float LevelAt(const RoleMap& map, float way) {
  const float shaped = Shaped(map, way);
  if (!Springs(map.control)) return map.from + shaped * (map.to - map.from);
  return (map.from + map.to) / 2 + shaped * ((map.to - map.from) / 2);
}

// x must rise in each step, since OnCurve divides by it; y may fall in between.
bool IsCurve(const std::vector<glm::vec2>& points) {
  const auto falls = [](const glm::vec2& a, const glm::vec2& b) { return !(a.x < b.x); };
  const auto outside = [](const glm::vec2& p) { return !(p.y >= 0 && p.y <= 1); };
  return points.size() >= 2 && points.size() <= kMostCurvePoints && points.front() == glm::vec2(0) &&
         points.back() == glm::vec2(1) && std::ranges::adjacent_find(points, falls) == points.end() &&
         std::ranges::none_of(points, outside);
}

void CheckRoles(const Roles& roles, std::vector<std::string>& faults) {
  if (roles.roles.size() > kMostRoles)
    return faults.push_back(
        fmt::format("roles: {}, and {} at most can be played", roles.roles.size(), kMostRoles));
  if (!(roles.handover_s >= 0 && roles.handover_s <= kLongestHandover_s))
    faults.push_back(fmt::format("roles: handover_s is not within 0 to {}", kLongestHandover_s));
  if (roles.mixes.size() > kMixCount)
    faults.push_back(fmt::format("roles: they play {} faces and expressions, and {} is the most",
                                 roles.mixes.size(), kMixCount));
  std::size_t maps = 0;
  for (const Role& role : roles.roles) {
    maps += role.maps.size();
    if (static_cast<std::size_t>(role.device) >= kDeviceCount) {
      faults.push_back(fmt::format("role \"{}\": its device is not known", role.name));
      continue;
    }
    for (const RoleMap& map : role.maps) MapChecker(roles, role, map, faults).Check();
    const auto falls = [](const RoleMap& a, const RoleMap& b) { return a.level > b.level; };
    if (std::ranges::adjacent_find(role.maps, falls) != role.maps.end())
      faults.push_back(fmt::format("role \"{}\": maps of one level do not stand together", role.name));
  }
  if (maps > kMostRoleMaps)
    faults.push_back(fmt::format("roles: {} maps, and {} at most can be played", maps, kMostRoleMaps));
}

// Dials have one digit: there are eight.
std::optional<NamedControl> ControlNamed(std::string_view name) {
  if (name.starts_with("dial ") && name.size() == 6 && name[5] >= '1' && name[5] < '1' + kDials)
    return NamedControl{Control::kDial, static_cast<std::uint8_t>(name[5] - '1')};
  const auto* const found = std::ranges::find(kControlNames, name);
  if (found == kControlNames.end() || name == "dial") return std::nullopt;
  return NamedControl{static_cast<Control>(found - kControlNames.begin())};
}

std::string NameOf(const RoleMap& map) {
  if (Turns(map.control)) return fmt::format("dial {}", map.dial + 1);
  const auto index = static_cast<std::size_t>(map.control);
  return index < kControlNames.size() ? std::string(kControlNames[index]) : "an unknown control";
}

}  // namespace kaori::show
