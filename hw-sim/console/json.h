// What the console tells its page, as JSON: the labels once, how things stand many times.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "drivers/base/result.h"
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
  // In the order in which the page shows them. What every show has, until it says more.
  std::vector<KeyLabel> keys{{.usage = 0x2C, .text = "Blink", .group = "blink"}};
};

// Reads the form that LabelsJson writes; what is left out keeps its default. Errors: those of the file;
// invalid_argument (no such form, too many entries, a usage beyond 231) with the file and the entry named.
Result<Labels> LoadLabels(const std::string& path);

// {"dials":[..], "buttons":[{"text","group"}..], "sticks":[..], "keys":[{"usage","text","group"}..]}
std::string LabelsJson(const Labels& labels);

// {"dials":[turns..], "buttons":bits, "lamps":bits, "sticks":[{"x","y","twist","slider"}..],
//  "lips":{"height","width"}, "covered":bool, "ports":{"dial-box":{"plugged","connected"}..}, "fps":number}
std::string StateJson(sim::Rig& rig, double frames_per_s);

}  // namespace kaori::console
