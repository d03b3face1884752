// Roles: which controls of which device move which levels. One person plays one of them, or several; a role
// is played from one device at a time, and may be moved to another while the show plays.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "appliance/core/show/call.h"
#include "appliance/core/show/level.h"

namespace kaori::show {

inline constexpr std::size_t kMostRoles = 8;
inline constexpr std::size_t kMostRoleMaps = 64;  // Of all roles together: State has room for each.
inline constexpr std::size_t kMostCurvePoints = 16;
// A hand-over that takes longer than this is a fade, which cues have.
inline constexpr float kLongestHandover_s = 10;
inline constexpr float kMostDead = 0.9F;  // Of a control's way from its middle, or from its beginning.
inline constexpr float kFlattestCurve = 0.1F, kSteepestCurve = 10;

// What operators play from, as the box's settings bind it to a port (programs/input/settings.h).
enum class Device : std::uint8_t { kLeftStick, kRightStick, kDialBox };
inline constexpr std::size_t kDeviceCount = 3;
inline constexpr std::array<std::string_view, kDeviceCount> kDeviceNames{"left stick", "right stick",
                                                                         "dial box"};

// A control that moves. Its way is -1..1 with a middle to which a spring brings it back, or 0..1 where it
// stays; a dial turns without ends, and only its turns count.
enum class Control : std::uint8_t { kX, kY, kTwist, kHatX, kHatY, kSlider, kDial };
inline constexpr std::size_t kControlCount = 7;

// A control is one of three kinds, which its place in the list tells: it springs back,
// stays, or turns without ends.
constexpr bool Springs(Control control) {
  return control < Control::kSlider;
}
constexpr bool StaysPut(Control control) {
  return control == Control::kSlider;
}
constexpr bool Turns(Control control) {
  return control == Control::kDial;
}
// Whether the device has such a control.
constexpr bool Has(Device device, Control control) {
  return (device == Device::kDialBox) == Turns(control);
}

// How a control that stays where it is put gets a level which something else has moved meanwhile.
enum class Takeover : std::uint8_t {
  kJump,    // At its first movement; the difference eases out.
  kPickUp,  // Where it meets the level, or passes it.
  kScale,   // At once and in proportion, so that both reach the end together.
};
inline constexpr std::array<std::string_view, 3> kTakeoverNames{"jump", "pickup", "scale"};

// How one control moves one level. A fresh one has no range yet, and CheckRoles refuses it.
struct RoleMap {
  Control control{};
  std::uint8_t dial = 0;  // Of Control::kDial, from 0.
  Level level{};
  // The level where the control is at the lower and at the upper end of its way; swapped: inverted. Of a
  // dial: `to` - `from` is what one turn clockwise adds.
  float from = 0, to = 0;
  float dead = 0;      // Of the way: nothing happens there.
  float exponent = 1;  // Of the way behind the dead zone, 0..1; 1 is straight.
  std::vector<glm::vec2>
      points{};  // Instead of the exponent: from {0, 0} to {1, 1}, x rising; straight between.
  Takeover takeover = Takeover::kJump;
};

struct Role {
  std::string name;
  // From what it is played when the show begins; learn mode and the box's own file may move it.
  Device device{};
  std::vector<RoleMap> maps;  // Those of one level stand together; they add up.
};

struct Roles {
  // In which what is left of the level's former value eases out when another owner has it. A longer way takes
  // longer: nothing moves further than 2 % of its range in a frame of a 60th of a second.
  float handover_s = 0.25F;
  std::vector<Role> roles;
  // Which faces and expressions the levels from Level::kMix1 on are of, kMixCount at most.
  std::vector<Call> mixes{};
};

// What a show without a roles.toml has: the dial box's dials, head by the left stick, gaze and brows by the
// right one.
Roles UsualRoles();

// The way of a control behind its dead zone and curve, with its sign. `way` is -1..1; 0, 1 and -1 stay.
float Shaped(const RoleMap& map, float way);

// Where the level is at this place of a control's way, in the level's own unit; not of dials.
float LevelAt(const RoleMap& map, float way);

// 2 to kMostCurvePoints points from {0, 0} to {1, 1} whose x rises; y is 0 to 1.
bool IsCurve(const std::vector<glm::vec2>& points);

// Everything that is wrong with them, as "role "head": reason" each; none: they can be played.
void CheckRoles(const Roles& roles, std::vector<std::string>& faults);

// Of the control as files and pages write it: "x", "slider", "dial 3". Nothing where there is none such.
struct NamedControl {
  Control control{};
  std::uint8_t dial = 0;
};
std::optional<NamedControl> ControlNamed(std::string_view name);
std::string NameOf(const RoleMap& map);

}  // namespace kaori::show
