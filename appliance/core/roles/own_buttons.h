// What the box's own roles.toml has buttons call in place of the show.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/roles/level_names.h"
#include "appliance/core/show/call.h"
#include "appliance/core/show/show.h"
#include "appliance/core/toml/section.h"

namespace kaori::roles {

// A button of the dial box, from 0, and what it calls on either sheet.
struct OwnButton {
  std::uint8_t button = 0;
  show::Call call;
};

// "face kaori", "expression angry" or "cue go"; nothing where the text is none of them. Pure.
std::optional<show::Call> CallNamed(std::string_view text, const Items& items);

// The same text of a call; empty for a call of another kind. Pure.
std::string NameOf(const show::Call& call, const Items& items);

// Reads one [[button]] with its `number`, from 1, and its `call`, and adds it. What is wrong becomes a fault
// of the section.
void ReadButton(toml::Section& section, const Items& items, std::vector<OwnButton>& buttons);

// Has the buttons call that, on both sheets of the show.
void Assign(const std::vector<OwnButton>& buttons, show::Show& show);

}  // namespace kaori::roles
