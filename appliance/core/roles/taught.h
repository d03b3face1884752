// What a person taught the box by moving a control, as lines of the box's own roles.toml.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/roles/level_names.h"
#include "appliance/core/show/roles.h"
#include "drivers/base/result.h"

namespace kaori::roles {

// One control of one device, and the level that it is to move.
struct Taught {
  std::string level;  // As files call it: "head_yaw", "expression angry".
  show::Device device{};
  // Of a face or an expression `level` is any mix: all of them have the same ends.
  show::RoleMap map;
};

// A button (show::kAllButtonCount), and what it is to call, as files call it: "cue go". One of the dial box
// calls it on either sheet.
struct TaughtButton {
  std::uint8_t button = 0;
  std::string call;
};

// A map of the whole level by a control: of its whole way, one turn of a dial. A spring's middle is the level's
// rest, so that the range is as wide as both sides allow; nothing where the level rests at an end, since the
// spring would hold it in its middle. `inverted`: the control's lower end is the level's upper one. Pure.
std::optional<show::RoleMap> MapOfWhole(show::Level level, const show::NamedControl& control, bool inverted);

// Levels that the control moves in these roles besides that one, as files call them. Pure.
std::vector<std::string> OtherLevelsOf(const show::Roles& roles, const Items& items, const Taught& taught);

// The text of the box's own file with what was taught in it: from then on the control moves this level and no
// other, and of the role that plays the level from that device nothing else does. Roles of other devices keep
// the level too. Lines that a person wrote stay, comments as well, but for maps that are replaced. `text` is
// the file as it is, empty where there is none; `below` are the show's roles, over which it lies. Pure.
// Errors, all invalid_argument (kInput):
//   `text` is wrong as it is, or the roles would be too many
//   its roles or maps are not written as tables of their own, [[role]] and [[role.map]]
Result<std::string> Teach(const std::string& text, const std::string& file, const Items& items,
                          const show::Roles& below, const Taught& taught);

// The same of a button. What its file said of that button is replaced.
Result<std::string> Teach(const std::string& text, const std::string& file, const Items& items,
                          const show::Roles& below, const TaughtButton& taught);

}  // namespace kaori::roles
