#include "appliance/authoring/inspect/folds.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace kaori::inspect {
namespace {

// Cosine of the angle to its surroundings: 107 degrees. A right angle would name the sharp edges of lids.
constexpr float kTurnedOver = -0.3F;
// A square of a hundredth of a millimetre: nobody sees where it looks.
constexpr float kNoArea_m2 = 1e-10F;

// Zero where the triangle has no area; its dot product with anything is then no fold.
glm::vec3 UnitNormal(std::span<const glm::vec3> fine, const face::Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const glm::vec3 normal = glm::cross(fine[b] - fine[a], fine[c] - fine[a]);
  const float length = glm::length(normal);
  return length > 2 * kNoArea_m2 ? normal / length : glm::vec3(0);
}

}  // namespace

// Two passes: normals of all triangles that meet the skin, summed by welded vertex; then each triangle of the
// skin against the sums at its corners.
Folds FindFolds(std::span<const glm::vec3> fine, const face::FineMesh& mesh, const std::vector<bool>& skin) {
  const auto weld = [&](face::Index v) { return std::min(v, mesh.twin[v]); };
  // By vertex; what no skin meets costs nothing.
  std::vector<bool> sought(fine.size(), false);
  for (std::size_t i = 0; i < skin.size(); ++i)
    if (skin[i])
      for (const face::Index v : mesh.triangles[i]) sought[weld(v)] = true;
  std::vector<glm::vec3> normals(mesh.triangles.size(), glm::vec3(0));
  // Sums of unit normals, not weighted by area: a sliver that is turned over counts as much
  // as its neighbours.
  std::vector<glm::vec3> around(fine.size(), glm::vec3(0));
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const face::Triangle& triangle = mesh.triangles[i];
    if (std::ranges::none_of(triangle, [&](face::Index v) { return sought[weld(v)]; })) continue;
    normals[i] = UnitNormal(fine, triangle);
    for (const face::Index v : triangle) around[weld(v)] += normals[i];
  }
  Folds folds;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (!skin[i]) continue;
    // Each corner's sum holds the triangle's own normal once; what is left is the others'.
    glm::vec3 sum = -3.0F * normals[i];
    for (const face::Index v : mesh.triangles[i]) sum += around[weld(v)];
    if (glm::dot(sum, normals[i]) >= kTurnedOver * glm::length(sum)) continue;
    const auto& [a, b, c] = mesh.triangles[i];
    if (folds.triangles.empty()) folds.at = (fine[a] + fine[b] + fine[c]) / 3.0F;
    folds.triangles.push_back(i);
  }
  return folds;
}

}  // namespace kaori::inspect
