// The bytes of the font that the program carries.
#pragma once

#include <cstddef>
#include <span>

namespace kaori::image {

// A TrueType file, as Debian's fonts-dejavu-core has it; lives as long as the program.
std::span<const std::byte> FontBytes();

}  // namespace kaori::image
