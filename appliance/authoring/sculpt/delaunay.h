// The Delaunay triangulation of points in the plane, by Qhull.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace kaori::sculpt {

// Three indices of points.
using Corners3 = std::array<std::size_t, 3>;

// Triangles counter-clockwise, as indices into `points`. Empty where the points do not span a plane. Points
// on one circle are split in a way that depends on the platform's arithmetic only where they lie on it
// exactly.
std::vector<Corners3> Delaunay(const std::vector<glm::dvec2>& points);

// The shares of a triangle's corners in `p` (barycentric coordinates); they sum to 1, one is negative
// outside. None for a flat triangle. Either winding.
std::optional<glm::dvec3> SharesIn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 p);

// The shares without negative ones and without dust (below 1e-7), summing to 1 again.
glm::dvec3 CleanShares(glm::dvec3 shares);

}  // namespace kaori::sculpt
