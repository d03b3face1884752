#include "appliance/authoring/sculpt/fine_mesh.h"

#include "appliance/authoring/mesh/subdivide.h"
#include "appliance/authoring/sculpt/texture_map.h"

namespace kaori::sculpt {

// Places of the fine vertices are interpolated in centimetres and then brought to the picture, not the other
// way round: TextureFromUv has knots.
face::FineMesh MakeFineMesh(const Cage& cage, const std::vector<glm::dvec2>& uvs_cm) {
  std::vector<mesh::Polygon> polygons;
  for (const Quad& quad : cage.quads) polygons.push_back(Corners(quad));
  std::vector<Index> weld;
  for (Index v = 0; v < cage.vertices.size(); ++v) weld.push_back(cage.Weld(v));
  face::FineMesh fine = mesh::Subdivide(polygons, weld);
  const face::SparseRows& rows = fine.attributes_from_cage;
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    glm::dvec2 uv_cm{};
    for (std::uint32_t i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i)
      uv_cm += static_cast<double>(rows.weight[i]) * uvs_cm[rows.column[i]];
    fine.texture.emplace_back(TextureFromUv(uv_cm));
  }
  return fine;
}

}  // namespace kaori::sculpt
