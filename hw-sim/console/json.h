// What the console tells its page about how things stand, as JSON, many times a second.
#pragma once

#include <string>

#include "hw-sim/console/dial_values.h"
#include "hw-sim/console/editor_watch.h"
#include "hw-sim/links/local/rig.h"

namespace kaori::console {

// {"dials":[turns..], "values":[number or null..], "buttons":bits, "lamps":bits,
//  "sticks":[{"x","y","twist","slider"}..], "lips":{"height","width"}, "covered":bool,
//  "pointer":{"x","y","buttons"}, "voice":{"vowel","loudness"}, "loudspeaker_db":number,
//  "needles":bool, "ports":{"dial-box":{"plugged","connected"}..}, "fps":number}
std::string StateJson(sim::Rig& rig, const DialValues& values, const EditorWatch& needles,
                      double frames_per_s);

}  // namespace kaori::console
