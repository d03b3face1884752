#include "appliance/authoring/import/fine_mesh.h"

#include <numeric>
#include <utility>

namespace kaori::import {
namespace {

// The quad that two triangles are, if they run along one edge in opposite ways; else the first one.
// Counter-clockwise, beginning at the shared edge's first corner in `a`.
mesh::Polygon Join(const Triangle& a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const bool shared = a[i] == b[(j + 1) % 3] && a[(i + 1) % 3] == b[j];
      if (shared) return {a[i], b[(j + 2) % 3], a[(i + 1) % 3], a[(i + 2) % 3]};
    }
  return {a[0], a[1], a[2]};
}

// The cage as its own fine mesh: an identity matrix, and triangles as they are.
face::FineMesh Cage(const std::vector<Triangle>& triangles, const std::vector<Index>& weld) {
  face::FineMesh fine;
  face::SparseRows& rows = fine.from_cage;
  rows.row_start.resize(weld.size() + 1);
  std::iota(rows.row_start.begin(), rows.row_start.end(), 0U);
  rows.column.resize(weld.size());
  std::iota(rows.column.begin(), rows.column.end(), 0U);
  rows.weight.assign(weld.size(), 1.0F);
  fine.attributes_from_cage = rows;
  fine.triangles = triangles;
  fine.twin = mesh::Twins(weld);
  return fine;
}

}  // namespace

// A triangle that is joined with the next one takes that one along.
std::vector<mesh::Polygon> PolygonsOf(const std::vector<Triangle>& triangles) {
  return PolygonsOf(triangles, [](Index, Index) { return false; });
}

std::vector<mesh::Polygon> PolygonsOf(const std::vector<Triangle>& triangles,
                                      const std::function<bool(Index, Index)>& is_wire) {
  std::vector<mesh::Polygon> polygons;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    mesh::Polygon polygon(t.begin(), t.end());
    // Only the triangle that follows is tried: that is how exporters split a quad.
    if (i + 1 < triangles.size()) polygon = Join(t, triangles[i + 1]);
    // The edge that they share runs from the first corner to the third.
    if (polygon.size() == 4 && is_wire(polygon[0], polygon[2])) polygon.assign(t.begin(), t.end());
    if (polygon.size() == 4) ++i;
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

face::FineMesh MakeFineMesh(const std::vector<Triangle>& triangles, const std::vector<Index>& weld,
                            const std::vector<glm::vec2>& uv) {
  face::FineMesh fine = triangles.size() > kMostSubdivided ? Cage(triangles, weld)
                                                           : mesh::Subdivide(PolygonsOf(triangles), weld);
  const face::SparseRows& rows = fine.attributes_from_cage;
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    // Attributes are interpolated, not smoothed like positions, so that a texture does not shrink
    // at its seams.
    glm::vec2 texture{};
    for (std::uint32_t i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i)
      texture += rows.weight[i] * uv[rows.column[i]];
    fine.texture.push_back(texture);
  }
  return fine;
}

}  // namespace kaori::import
