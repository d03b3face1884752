// A face's texture in the memory of the graphics driver.
#pragma once

#include "render/face/cast.h"
#include "render/gl/texture.h"

namespace kaori::passes {

// Holds square roots of linear light, 8 bit, which the shader squares (render/shaders/skin_texture.glsl): a
// software renderer filters plain bytes far faster than sRGB. Alpha is gloss, as it is. With mipmaps; bottom
// row first. Blocks for some 10 ms, and allocates as much as the texture has.
gl::Texture LoadSkin(const face::Texture& texture);

}  // namespace kaori::passes
