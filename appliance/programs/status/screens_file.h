// The file "screens" beside the board: which outputs the stage drives, for the programs that say how the box
// does. kaori-stage writes it whole when outputs change; kaori-status and kaori-desk read it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/ports/output.h"

namespace kaori::status {

// The file's text: a line for each output, with five words separated by single spaces:
//   connector  WIDTHxHEIGHT  rate in Hz  origin of the mode  state
// as in "HDMI-A-1 1920x1080 59.94 wanted picture". Origins: wanted, substitute, safe. States: picture,
// unplugged, status, monitor. Pure.
std::string FormatScreens(std::span<const ports::Output> outputs);

// The outputs of such a text, at most 64. A line that is none is passed over: a reader of another version
// must not fail. Pure.
std::vector<ports::Output> ParseScreens(std::string_view text);

}  // namespace kaori::status
