// What hands do at the console's page, as lines of text: "dial 1 turn 0.4".
//
// Dials and buttons count from 1, as they are written on the box. The lines, one hand each:
//   dial N turn TURNS            clockwise is positive; 4 turns at most in one line
//   button N push | release
//   stick left|right move X Y    -1..1: right, forwards
//   stick left|right twist V     -1..1: clockwise, seen from above
//   stick left|right slide V     0..1
//   stick left|right hat centre | 0..7    0 is up, clockwise in eighths
//   stick left|right push N | release N
//   key USAGE press | release    HID keyboard usage, 4..231
//   lips HEIGHT WIDTH            0..2 each, in widths of the mouth at rest
//   lens cover | open
//   cable PORT plug | pull       PORT as in hw-sim/devices/hand.h: dial-box, camera ...
#pragma once

#include <string_view>
#include <vector>

#include "drivers/base/result.h"
#include "hw-sim/devices/hand.h"

namespace kaori::console {

// Reads every line of `text`; empty lines are none. All or nothing: one wrong line gives only an Error
// (invalid_argument) whose attempt names the line and what it should be.
Result<std::vector<sim::Hand>> ParseHands(std::string_view text);

}  // namespace kaori::console
