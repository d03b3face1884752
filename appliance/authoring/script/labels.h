// What a show writes on the operators' controls, for the simulator's page and for stickers on a real box.
#pragma once

#include <string>

#include "appliance/core/show/show.h"

namespace kaori::authoring {

// The labels of `show` as JSON, in the form that hw-sim/console/labels.h describes: 8 dials with the values
// they play, 32 buttons and their groups, two sticks, and the keys that do something. `show` must be valid.
// Texts that are not UTF-8 get replacement characters.
std::string LabelsJson(const show::Show& show);

// For people: "in_love" -> "In love". The first letter alone is made large, and only an ASCII one.
std::string Readable(std::string name);

}  // namespace kaori::authoring
