// How the page shows the camera's picture: as it is, with the paint brought out, or the paint alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace kaori::desk {

enum class View : std::uint8_t { kPlain, kBoth, kMask };
inline constexpr std::size_t kViewCount = 3;

// From R, G, B and paint to R, G, B and nothing, pixel by pixel.
void Compose(View view, std::span<const std::uint8_t> rgbp, std::vector<std::uint8_t>& rgbx);

}  // namespace kaori::desk
