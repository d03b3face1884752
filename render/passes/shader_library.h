// The shaders of render/shaders, carried in the program.
#pragma once

#include <span>

#include "render/gl/program.h"

namespace kaori::passes {

// Every file of that folder under its name, such as "skin.glsl". Lives as long as the program.
std::span<const gl::ShaderFile> ShaderLibrary();

}  // namespace kaori::passes
