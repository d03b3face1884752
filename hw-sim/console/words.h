// What the console tells its page, as JSON: the labels once, how things stand many times.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "hw-sim/links/local/rig.h"

namespace kaori::console {

struct ButtonLabel {
  std::string text{};
  std::string group{};  // Buttons of one group have one colour: "face", "expression", "style", "scene" or "".
};

struct KeyLabel {
  std::uint8_t usage = 0;  // HID keyboard usage.
  std::string text{};
  std::string group{};  // "blink", "take", "scene" or "".
};

// What is written on the devices; an empty text leaves the number alone.
struct Labels {
  std::array<std::string, 8> dials;
  std::array<ButtonLabel, 32> buttons;
  std::array<std::string, 2> sticks;  // Left, right.
  std::vector<KeyLabel> keys;         // In the order in which the page shows them.
};

// {"dials":[..], "buttons":[{"text","group"}..], "sticks":[..], "keys":[{"usage","text","group"}..]}
std::string LabelsJson(const Labels& labels);

// {"dials":[turns..], "buttons":bits, "lamps":bits, "sticks":[{"x","y","twist","slider"}..],
//  "lips":{"height","width"}, "covered":bool, "ports":{"dial-box":{"plugged","connected"}..}, "fps":number}
std::string StateJson(sim::Rig& rig, double frames_per_s);

}  // namespace kaori::console
