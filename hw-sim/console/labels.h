// What is written on the simulated devices, so that the page can say what each control does.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "firmware/wire/stick_pod.h"

namespace kaori::console {

// A label tells people; nothing that is played depends on it.
// A dial has no end; what it plays may have one. Where `low` and `high` differ the page shows that value.
struct DialLabel {
  // What turning it does.
  std::string text{};
  std::string unit{};  // "%" (of 1), "s", or "".
  // The ends of the value, in the label's unit; equal where there is none.
  double low = 0;
  double high = 0;
  double per_turn = 0;  // Added by one turn clockwise.
  double start = 0;     // When the show opens.
  // Buttons and keys of these groups put it to 1: what is called comes whole.
  std::vector<std::string> filled_by{};

  // Whether the page shows a number.
  bool has_value() const { return high > low; }
};

// What a button of the box does.
struct ButtonLabel {
  // What pushing it does.
  std::string text{};
  std::string group{};  // Buttons of one group have one colour: "face", "expression", "style", "scene" or "".
};

// The words beside a stick's two axes, its twist and its slider, and on its buttons.
struct StickLabel {
  // What the stick itself does when it is moved.
  std::string text{};
  std::string twist{};
  std::string slide{};
  std::array<ButtonLabel, wire::kStickPodButtons> buttons{};
};

// A key that the show uses; others are not drawn.
struct KeyLabel {
  std::uint8_t usage = 0;  // HID keyboard usage.
  // What it does.
  std::string text{};
  std::string group{};  // "blink", "motion", "scene" or "".
};

// A cue of the show's list, as whoever calls it reads it.
struct CueLabel {
  std::string number{};
  std::string text{};
  std::string act{};  // Where an act begins.
  std::string notes{};
  bool by_itself = false;  // No GO is waited for: the cue before brings it.
};

// A level of the show, which roles and remote controls move.
struct LevelLabel {
  std::string text{};
  std::string unit{};                  // For people; empty: none.
  double per_unit = 1;                 // What one of that unit is in the value that the box tells.
  double low = 0, high = 1, rest = 0;  // Of that value.
};

// A registered motion or a take of the show.
struct MotionLabel {
  std::string text{};
  std::string moves{};  // The parts of the face to which it is added: "head, gaze".
  double length_s = 0;
  bool loops = false;  // It plays until something ends it.
  bool take = false;   // A person played it.
  bool sound = false;
};

// All that is written on the devices, for one show: made by the authoring tool from the show's
// files. An empty text leaves the number alone.
struct Labels {
  // The show's name, as the page's heading.
  std::string show{};
  // From the upper left, as on the box.
  std::array<DialLabel, 8> dials;
  std::array<ButtonLabel, 32> buttons, second_buttons;  // Of both sheets.
  std::array<StickLabel, 2> sticks;                     // Left, right.
  // Names by the show's numbers, which the stage tells; of the ways of drawing too.
  std::vector<std::string> scenes{};
  std::vector<std::string> styles{};
  // In their order, by which the stage counts.
  std::vector<CueLabel> cues{};
  // In their orders, by which the stage counts; the devices from which roles are played.
  std::vector<LevelLabel> levels{};
  std::vector<std::string> roles{};
  std::vector<std::string> devices{};
  std::vector<std::string> teachable{};  // Levels that may be taught, as board::Learn counts them.
  std::vector<MotionLabel> motions{};    // In their order, by which the stage counts.
  // In the order in which the page shows them. What every show has, until it says more.
  std::vector<KeyLabel> keys{{.usage = 0x2C, .text = "Blink", .group = "blink"}};
};

// Reads the form that LabelsJson writes; what is left out keeps its default, and a text alone will do
// for a dial or a stick. Entries that are not known are passed over, so that newer files are read too.
// Blocks for the disk. Errors: those of the file; invalid_argument (no such form, too many entries, a
// usage beyond 231) with the file and the entry named.
Result<Labels> LoadLabels(const std::string& path);

// {"show":text, "dials":[{"text","unit","low","high","per_turn","start","filled_by":[..]}..],
//  "buttons":[{"text","group"}..], "second_buttons":[..], "sticks":[{"text","twist","slide","buttons":[..]}..],
//  "scenes":[name..], "styles":[name..], "keys":[{"usage","text","group"}..],
//  "cues":[{"number","text","act","notes","by_itself"}..], "levels":[{"text","unit","per_unit","low","high","rest"}..],
//  "roles":[name..], "devices":[name..], "teachable":[name..],
//  "motions":[{"text","moves","length_s","loops","take","sound"}..]}
std::string LabelsJson(const Labels& labels);

}  // namespace kaori::console
