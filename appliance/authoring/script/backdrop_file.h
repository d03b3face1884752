// A scene's backdrop in show.toml: { kind = "curtain", top = "#6a1420", bottom = "#2a0810" }.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "appliance/core/toml/section.h"
#include "render/face/cast.h"
#include "render/scene/scene.h"

namespace kaori::authoring {

// Reads the table; faults go to the section: unknown keys and kinds, texts that are no colour, pictures that
// are no PNG or larger than 4096 pixels a side. A picture is a PNG file beside show.toml, in `folder`; it is
// appended to `textures`, top row first, and the backdrop keeps its number. Colours are optional for a
// picture, "glow" always.
scene::Backdrop ReadBackdrop(toml::Section section, const std::filesystem::path& folder,
                             std::vector<face::Texture>& textures);

// As ReadBackdrop reads it: "curtain".
std::string NameOf(scene::BackdropKind kind);

}  // namespace kaori::authoring
