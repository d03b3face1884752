// Names of what is numbered in a show: the words of show.toml.
#pragma once

#include <array>

#include "render/scene/scene.h"

namespace kaori::authoring {

// In the order of scene::Style.
inline constexpr std::array<const char*, scene::kStyleCount> kStyleNames{"wire", "flat", "bare", "hair",
                                                                         "soft"};

}  // namespace kaori::authoring
