// The views of the camera's picture on the page: as it is, with the paint emphasised, or the paint alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace kaori::desk {

// The picture, the picture with emphasised paint, and the mask of the paint.
enum class View : std::uint8_t { kPlain, kBoth, kMask };
inline constexpr std::size_t kViewCount = 3;

// Converts pixels of R, G, B and paint to pixels of R, G, B and an unused byte. `rgbx` is resized. A last
// pixel that is not whole is left out. Pure.
void Compose(View view, std::span<const std::uint8_t> rgbp, std::vector<std::uint8_t>& rgbx);

}  // namespace kaori::desk
