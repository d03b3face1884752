// What the console tells its page about how things stand, as JSON, many times a second.
#pragma once

#include <string>

#include "drivers/base/json.h"
#include "hw-sim/console/dial_values.h"
#include "hw-sim/console/editor_watch.h"
#include "hw-sim/links/local/rig.h"

namespace kaori::console {

// One object, without line breaks, so that it fits into one "data:" line of the events:
//   {"dials":[turns..], "values":[number or null..], "buttons":bits, "lamps":bits,
//    "sticks":[{"x","y","twist","slider","hat","buttons"}..], "lips":{"height","width"}, "covered":bool,
//    "pointer":{"x","y","buttons"}, "voice":{"vowel","loudness"}, "loudspeaker_db":number,
//    "editor_open":bool, "lines":{"closed":bits,"tally":bool}, "on_stage":`on_stage`,
//    "ports":{"dial-box":{"plugged","connected"}..}, "fps":number}
// Units are those of the devices' own headers; bit n stands for button, lamp or
// line n. `on_stage` is as ConsoleOptions::on_stage. page/wire.js reads it.
std::string StateJson(sim::Rig& rig, const DialValues& values, const EditorWatch& editor,
                      json::Value on_stage, double frames_per_s);

}  // namespace kaori::console
