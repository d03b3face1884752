// Colours: linear RGB inside, "#rrggbb" in files and sRGB bytes in textures.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <glm/vec3.hpp>

namespace kaori::appearance {

// The linear colour of "#rrggbb" (sRGB); nothing where the text is no such colour.
std::optional<glm::vec3> ColourFromHex(std::string_view text);

// For colours that are written in code and therefore well formed: asserted.
glm::vec3 Hex(std::string_view text);

// The sRGB byte of a linear value; clamps to 0..1. Table-driven: exact to the nearest byte but for rounding.
std::uint8_t ToSrgbByte(float linear);

}  // namespace kaori::appearance
