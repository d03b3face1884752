// The shaders of render/shaders, carried in the program.
#pragma once

#include <span>

#include "render/gl/program.h"

namespace kaori::passes {

std::span<const gl::ShaderFile> ShaderLibrary();

}  // namespace kaori::passes
