// Pictures that come inside a file from outside: PNG and JPEG.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/result.h"
#include "render/face/cast.h"

namespace kaori::import {

inline constexpr int kMostSide_px = 8192;

// As a texture, top row first; alpha becomes the gloss of skin. Errors: invalid_argument (no valid PNG or
// JPEG, or larger than kMostSide_px).
Result<face::Texture> DecodePicture(std::span<const std::uint8_t> bytes);

}  // namespace kaori::import
