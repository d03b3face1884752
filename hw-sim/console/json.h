// What the console tells its page about how things stand, as JSON, many times a second.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hw-sim/console/dial_values.h"
#include "hw-sim/console/editor_watch.h"
#include "hw-sim/links/local/rig.h"

namespace kaori::console {

// What the stage shows: numbers as the show counts its scenes and ways of drawing, from 0. Labels has their names.
struct OnStage {
  std::uint32_t scene = 0;
  std::uint32_t style = 0;
  // The cue list; cues by their places in it, from 0. As board::StageStatus has them.
  std::int32_t cue = -1;
  std::int32_t standby = 0;
  std::int32_t pending = -1;
  float left_s = 0;
  bool paused = false, panicking = false, black = false, waiting = false;
  std::uint32_t refused = 0;
};

// One object, without line breaks, so that it fits into one "data:" line of the events:
//   {"dials":[turns..], "values":[number or null..], "buttons":bits, "lamps":bits,
//    "sticks":[{"x","y","twist","slider","hat","buttons"}..], "lips":{"height","width"}, "covered":bool,
//    "pointer":{"x","y","buttons"}, "voice":{"vowel","loudness"}, "loudspeaker_db":number,
//    "editor_open":bool, "lines":{"closed":bits,"tally":bool}, "on_stage":{"scene","style","cue",
//    "standby","pending","left_s","paused","panicking","black","waiting","refused"} or null,
//    "ports":{"dial-box":{"plugged","connected"}..}, "fps":number}
// Units are those of the devices' own headers; bit n stands for button, lamp or
// line n. page/wire.js reads it.
std::string StateJson(sim::Rig& rig, const DialValues& values, const EditorWatch& editor,
                      const std::optional<OnStage>& on_stage, double frames_per_s);

}  // namespace kaori::console
