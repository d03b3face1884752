// Where a uv of the head's unrolled surface lies in the texture, and the exact way back for the painter.
#pragma once

#include <glm/vec2.hpp>

namespace kaori::sculpt {

// The unrolled surface in centimetres of the reference face: u runs round the head from the seam at the back
// (-21) over the middle of the face (0) to the seam (21), positive on the character's left; v runs up. Near
// the face u and v are the reference face's own x and y.
inline constexpr glm::dvec2 kUvMin_cm{-21.0, -17.5};
inline constexpr glm::dvec2 kUvMax_cm{21.0, 13.5};

// Topology::uv, the unit square, without any stretch; (-21, -17.5) becomes (0, 0).
glm::dvec2 UnitFromUv(glm::dvec2 uv_cm);

// Topology::texture, v up: the face (|u| < 7, -10.2 < v < 5) gets 62 x 70 percent of the picture, since that
// is where brows and lashes need the texels. Piecewise linear with its knots on lines of the mesh's grid, so
// that no triangle bends across one; the two are each other's inverse. Left and right are mirror images.
glm::dvec2 TextureFromUv(glm::dvec2 uv_cm);
// The way back, also outside the picture.
glm::dvec2 UvFromTexture(glm::dvec2 texture);

}  // namespace kaori::sculpt
