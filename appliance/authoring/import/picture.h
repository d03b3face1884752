// Pictures that come inside a file from outside: PNG and JPEG.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/result.h"
#include "render/face/cast.h"

namespace kaori::import {

// Larger pictures are refused before memory for them is asked for; face::Texture allows no more either.
inline constexpr int kMostSide_px = 8192;

// As a texture, top row first, sRGB as it stands in the file. Its own alpha is not kept: a skin's alpha is
// gloss, and all of it becomes the gloss of skin. The format is told by the first byte. Errors:
// invalid_argument (empty, no valid PNG or JPEG, or larger than kMostSide_px).
Result<face::Texture> DecodePicture(std::span<const std::uint8_t> bytes);

}  // namespace kaori::import
