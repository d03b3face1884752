#include "appliance/authoring/sculpt/carve.h"

#include "appliance/authoring/sculpt/aim_table.h"
#include "appliance/authoring/sculpt/ear.h"
#include "appliance/authoring/sculpt/eye_rings.h"
#include "appliance/authoring/sculpt/mouth_rings.h"
#include "appliance/authoring/sculpt/uv_grid.h"

namespace kaori::sculpt {
namespace {

// Aims and projects each vertex of the grid. Vertices in the middle of the face, in the middle of the back
// and on the crown belong to both halves: they lie on x = 0 exactly, or the halves would gape.
void PlaceGridVertices(const HalfTopology& half, const AimTable& aim, const Carved& recipe,
                       HalfShape& shape) {
  const std::vector<glm::dvec3> aimed = AimedGrid(aim, recipe.scale);
  const std::vector<glm::dvec2> uvs_cm = UvGrid();
  for (Index v = 0; v < half.keys.size(); ++v) {
    const Key& key = half.keys[v];
    if (key.region != Region::kGrid) continue;
    const auto at = static_cast<std::size_t>(key.b) * (kColumns + 1) + static_cast<std::size_t>(key.a);
    shape.position[v] = Project(recipe.bodies, aimed[at], ProjectionDirection({key.a, key.b}, aimed[at]));
    shape.uv_cm[v] = uvs_cm[at];
    if (key.a == 0 || key.a == kColumns || key.b == kRows) shape.position[v].x = 0;
  }
}

// Sets what was written by hand. Before the rings: those of the mouth start from the grid.
void Touch(const HalfTopology& half, const std::vector<Landmark>& touches, HalfShape& shape) {
  for (const Landmark& touch : touches) {
    shape.position[half.At(touch.vertex.region, touch.vertex.a, touch.vertex.b)] = touch.target;
  }
}

}  // namespace

// The order matters: rings start from the grid's vertices on their rims, which must lie on the skin by then.
HalfShape Carve(const HalfTopology& half, const AimTable& aim, const Carved& recipe) {
  HalfShape shape;
  shape.position.resize(half.keys.size());
  shape.uv_cm.resize(half.keys.size());
  PlaceGridVertices(half, aim, recipe, shape);
  Touch(half, recipe.touches, shape);
  PlaceEyeRings(half, recipe.bodies, recipe.eye, shape);
  PlaceMouthRings(half, recipe.bodies, recipe.mouth, shape);
  PlaceEar(half, recipe.bodies, recipe.ear, shape);
  return shape;
}

}  // namespace kaori::sculpt
