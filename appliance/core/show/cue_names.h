// How files call what a person calls while a cue list is played.
#pragma once

#include <array>
#include <string_view>

#include "appliance/core/show/cue.h"
#include "render/scene/scene.h"

namespace kaori::show {

// In the order of CueVerb.
inline constexpr std::array<std::string_view, kCueVerbCount> kCueVerbNames{"go",    "back",  "stop",
                                                                           "pause", "panic", "blackout"};
// In the order of scene::Style.
inline constexpr std::array<std::string_view, scene::kStyleCount> kStyleNames{"wire", "flat", "bare", "hair",
                                                                              "soft"};

}  // namespace kaori::show
