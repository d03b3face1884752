// What a picture key shows of a call, before it is drawn.
#pragma once

#include <optional>
#include <string>

#include "appliance/core/show/show.h"
#include "render/scene/scene.h"

namespace kaori::authoring {

// Close enough that a face fills a key. Nothing: the call has no picture but its name (cues, motions, blinks). `show` is
// valid, and has a scene. Pure.
std::optional<scene::Scene> SceneOfKey(const show::Call& call, const show::Show& show);

// What is written on the key: "Old woman" of "face old_woman", "Go" of "cue go", "Cue 14" of "cue 14". Pure.
std::string TextOfKey(const std::string& call);

}  // namespace kaori::authoring
