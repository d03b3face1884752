// A face's texture in the memory of the graphics driver.
#pragma once

#include <cstdint>

#include "render/face/cast.h"
#include "render/gl/texture.h"

namespace kaori::passes {

enum class SkinTexels : std::uint8_t {
  kRoots,  // Square roots of linear light, to be squared by the shader: a software renderer filters plain
           // bytes far faster than sRGB.
  kCodes,  // sRGB's codes, as they are.
};

gl::Texture LoadSkin(const face::Texture& texture, SkinTexels texels = SkinTexels::kRoots);

}  // namespace kaori::passes
