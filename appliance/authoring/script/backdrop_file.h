// A scene's backdrop in show.toml: { kind = "curtain", top = "#6a1420", bottom = "#2a0810" }.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include "render/face/cast.h"
#include "render/scene/scene.h"

namespace kaori::authoring {

struct BackdropReading {
  scene::Backdrop backdrop;
  std::vector<std::string> faults;  // Reasons, one line each; the caller says in which scene.
};

// A picture is a PNG file beside show.toml, in `folder`; it is appended to `textures`.
BackdropReading ReadBackdrop(const toml::node* backdrop, const std::filesystem::path& folder,
                             std::vector<face::Texture>& textures);

// "curtain".
const char* NameOf(scene::BackdropKind kind);

}  // namespace kaori::authoring
