// A face's texture in the memory of the graphics driver.
#pragma once

#include <vector>

#include "render/face/cast.h"
#include "render/gl/texture.h"

namespace kaori::passes {

// Holds square roots of linear light, 8 bit, which the shader squares (render/shaders/skin_texture.glsl): a
// software renderer filters plain bytes far faster than sRGB. Alpha is gloss, as it is. With mipmaps; bottom
// row first. Blocks for some 10 ms, and allocates as much as the texture has.
gl::Texture LoadSkin(const face::Texture& texture);

// What of that needs no driver, on any thread; and the rest of it. `levels` are of this texture.
std::vector<gl::MipLevel> SkinLevels(const face::Texture& texture);
gl::Texture LoadSkin(const std::vector<gl::MipLevel>& levels);

}  // namespace kaori::passes
