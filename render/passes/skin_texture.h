// A face's texture in the memory of the graphics driver.
#pragma once

#include "render/face/cast.h"
#include "render/gl/texture.h"

namespace kaori::passes {

// Holds square roots of linear light, to be squared by the shader: a software renderer filters plain bytes
// far faster than sRGB.
gl::Texture LoadSkin(const face::Texture& texture);

}  // namespace kaori::passes
