// A scene's backdrop in show.toml: { kind = "curtain", top = "#6a1420", bottom = "#2a0810" }.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "appliance/core/toml/section.h"
#include "render/face/cast.h"
#include "render/scene/scene.h"

namespace kaori::authoring {

// Reads the table; faults go to the section. A picture is a PNG file beside show.toml, in `folder`; it is
// appended to `textures`, top row first.
scene::Backdrop ReadBackdrop(toml::Section section, const std::filesystem::path& folder,
                             std::vector<face::Texture>& textures);

// "curtain".
std::string NameOf(scene::BackdropKind kind);

}  // namespace kaori::authoring
