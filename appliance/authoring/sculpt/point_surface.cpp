#include "appliance/authoring/sculpt/point_surface.h"

#include <algorithm>
#include <array>

#include "appliance/authoring/sculpt/delaunay.h"

namespace kaori::sculpt {
namespace {

// Corners of a triangle of the half, and their shares in a point, cleaned of negative ones.
struct Spot {
  std::array<Index, 3> corner{};
  glm::dvec3 share{};
  double inside = -1e9;  // The smallest share before cleaning: how deep the point lies in the triangle.
};

// Behind the edges of lips and lids uv lie inside the holes, and overlap.
bool IsSkin(const Key& key) {
  return !(key.region == Region::kEye && key.b > kLidRing) &&
         !(key.region == Region::kMouth && key.b > kLipContactRing);
}

// Keeps the triangle in which the uv lies deepest.
void Try(const HalfShape& reference, std::array<Index, 3> corner, glm::dvec2 uv_cm, Spot& best) {
  const auto shares =
      SharesIn(reference.uv_cm[corner[0]], reference.uv_cm[corner[1]], reference.uv_cm[corner[2]], uv_cm);
  if (!shares) return;
  const double inside = std::min({shares->x, shares->y, shares->z});
  if (inside > best.inside) best = {corner, CleanShares(*shares), inside};
}

// The triangle that holds the uv; at the edge of a slit, or off the surface, the one that misses it by
// least. Every triangle is tried: once for each of some hundred points.
Spot FindSpot(const HalfTopology& half, const HalfShape& reference, glm::dvec2 uv_cm) {
  Spot best;
  for (const Quad& quad : half.quads) {
    const std::vector<Index> q = Corners(quad);
    const bool skin = std::all_of(q.begin(), q.end(), [&half](Index v) { return IsSkin(half.keys[v]); });
    if (!skin) continue;
    Try(reference, {q[0], q[1], q[2]}, uv_cm, best);
    if (q.size() == 4) Try(reference, {q[0], q[2], q[3]}, uv_cm, best);
  }
  return best;
}

// One row of the matrix; `side` leads from the half to the cage.
void Append(const Spot& spot, const std::vector<Index>& side, face::SparseRows& rows) {
  for (int i = 0; i < 3; ++i) {
    if (spot.share[i] == 0) continue;
    rows.column.push_back(side[spot.corner[static_cast<std::size_t>(i)]]);
    rows.weight.push_back(static_cast<float>(spot.share[i]));
  }
  rows.row_start.push_back(static_cast<std::uint32_t>(rows.column.size()));
}

}  // namespace

// A pair's spot is looked for once, on the left: on the right it has the mirrored vertices and the same
// weights.
face::SparseRows PointsOnSurface(const Cage& cage, const HalfShape& reference,
                                 const std::vector<AuthoredPoint>& points) {
  face::SparseRows rows;
  rows.row_start.push_back(0);
  for (const AuthoredPoint& point : points) {
    const Spot spot = FindSpot(cage.half, reference, point.uv_cm);
    Append(spot, cage.left, rows);
    if (point.paired) Append(spot, cage.right, rows);
  }
  return rows;
}

}  // namespace kaori::sculpt
