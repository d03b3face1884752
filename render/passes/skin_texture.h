// A face's texture in the memory of the graphics driver.
#pragma once

#include "render/face/cast.h"
#include "render/gl/texture.h"

namespace kaori::passes {

gl::Texture LoadSkin(const face::Texture& texture);

}  // namespace kaori::passes
