// What the box's own roles.toml has buttons call in place of the show.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/roles/level_names.h"
#include "appliance/core/show/call.h"
#include "appliance/core/show/roles.h"
#include "appliance/core/show/show.h"
#include "appliance/core/toml/section.h"

namespace kaori::roles {

// A button (show::kAllButtonCount), and what it calls; one of the dial box on either sheet.
struct OwnButton {
  std::uint8_t button = 0;
  show::Call call;
};

// A button and its device, as files and people count them: from 1.
struct NamedButton {
  show::Device device = show::Device::kDialBox;
  int number = 1;
};
NamedButton NameOfButton(std::uint8_t button);
std::uint8_t ButtonNamed(const NamedButton& named);

// "face kaori", "expression angry", "motion nod", "scene night", "style wire", "blink", "wink left", "cue go" or
// "cue 14"; "toggle" or "momentary" may stand before a face or an expression. Nothing where the text is none of
// them. Pure.
std::optional<show::Call> CallNamed(std::string_view text, const Items& items);

// The same text of a call; empty for a call of another kind. Pure.
std::string NameOf(const show::Call& call, const Items& items);

// By which the picture of a call is found, in the show's pictures and on the board (board::ButtonCalls): a number
// of the show's name and of what is called, however it joins. 0 for a call that has no name. Pure.
std::uint64_t SumOfCall(show::Call call, std::string_view show_name, const Items& items);

// All that a button may be taught to call, in the order in which learn mode offers it. Pure.
std::vector<std::string> TeachableCalls(const Items& items);

// The button that `number`, from 1, and `device` of a [[button]] name; the dial box's where it names no device.
// A number that the device has not is a fault of the section, and reads as 1.
NamedButton ReadNamedButton(toml::Section& section);

// Reads one [[button]] with its `number`, from 1, its `call` and its `device`, which is the dial box where none
// is given, and adds it. What is wrong becomes a fault
// of the section.
void ReadButton(toml::Section& section, const Items& items, std::vector<OwnButton>& buttons);

// Has the buttons call that; those of the dial box on both sheets of the show.
void Assign(const std::vector<OwnButton>& buttons, show::Show& show);

}  // namespace kaori::roles
