#include "appliance/authoring/mesh/sparse_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include "render/face/composer.h"

namespace kaori::mesh {
namespace {

using face::Index;
using face::Shape;
using face::Triangle;

// A polygon of the cage as Subdivide splits it: edges[i] lies between corners[i] and the next one.
struct SplitPolygon {
  std::vector<Index> corners;
  std::vector<Index> edges;
  Index middle = 0;

  Index after(std::size_t i) const { return corners[(i + 1) % corners.size()]; }
};

// Two triangles for each corner, from the corner over its edges to the middle. Empty where the triangles are not
// so.
std::vector<SplitPolygon> PolygonsOf(const std::vector<Triangle>& triangles) {
  std::vector<SplitPolygon> polygons;
  for (std::size_t i = 0; i + 1 < triangles.size();) {
    SplitPolygon polygon{{}, {}, triangles[i][2]};
    while (i + 1 < triangles.size() && triangles[i][2] == polygon.middle &&
           triangles[i + 1][1] == polygon.middle && triangles[i][0] == triangles[i + 1][0]) {
      polygon.corners.push_back(triangles[i][0]);
      polygon.edges.push_back(triangles[i][1]);
      i += 2;
    }
    if (polygon.corners.size() < 3) return {};
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

// Which vertices the surface cannot do without, after looks at it in many poses.
class Keeper {
 public:
  // Borrows all.
  Keeper(const face::FineMesh& fine, const std::vector<SplitPolygon>& polygons, const Flatness& flatness)
      : fine_(fine), polygons_(polygons), flatness_(flatness), kept_(fine.from_cage.rows()) {
    std::vector<int> sides(kept_.size());
    for (const SplitPolygon& p : polygons_) {
      for (std::size_t i = 0; i < p.corners.size(); ++i) {
        const Index edge = p.edges[i];
        ++sides[edge];
        if (fine_.twin[edge] != edge) ++sides[fine_.twin[edge]];
        if (TextureBends(p.corners[i], p.after(i), edge)) kept_[edge] = true;
      }
    }
    // A border moves along the surface too, where it would gape.
    for (std::size_t v = 0; v < sides.size(); ++v)
      if (sides[v] == 1) kept_[v] = true;
  }

  // Keeps what is not flat in this pose, too.
  void LookAt(const Shape& shape) {
    for (const SplitPolygon& p : polygons_) {
      for (std::size_t i = 0; i < p.corners.size(); ++i)
        if (Bends(shape, p.corners[i], p.after(i), p.edges[i])) kept_[p.edges[i]] = true;
      if (Bulges(shape, p)) kept_[p.middle] = true;
    }
  }

  // On a seam of the texture an edge has a vertex for each of its sides.
  std::vector<bool> Kept() const {
    std::vector<bool> kept = kept_;
    for (std::size_t v = 0; v < kept.size(); ++v) kept[v] = kept_[v] || kept_[fine_.twin[v]];
    return kept;
  }

 private:
  bool TextureBends(Index a, Index b, Index between) const {
    const glm::vec2 straight = 0.5F * (fine_.texture[a] + fine_.texture[b]);
    return glm::distance(fine_.texture[between], straight) > flatness_.texture;
  }

  bool Turns(const Shape& shape, Index a, Index b) const {
    return glm::distance(shape.fine_normals[a], shape.fine_normals[b]) > flatness_.turn_rad;
  }

  // Along the surface a vertex may lie anywhere: subdivision draws it towards its neighbours.
  bool Bends(const Shape& shape, Index a, Index b, Index between) const {
    const glm::vec3 off = shape.fine[between] - 0.5F * (shape.fine[a] + shape.fine[b]);
    return std::abs(glm::dot(off, shape.fine_normals[between])) > flatness_.height_m || Turns(shape, a, b) ||
           Turns(shape, a, between) || Turns(shape, b, between);
  }

  // Between opposite corners, whichever diagonal will be taken.
  bool Bulges(const Shape& shape, const SplitPolygon& p) const {
    const std::size_t n = p.corners.size();
    for (std::size_t i = 0; i < n; ++i)
      if (Bends(shape, p.corners[i], p.corners[(i + n / 2) % n], p.middle)) return true;
    return false;
  }

  const face::FineMesh& fine_;
  const std::vector<SplitPolygon>& polygons_;
  const Flatness flatness_;
  std::vector<bool> kept_;
};

// All that a face does, each thing alone: played on top of the first expression, or in its place.
std::vector<face::Weights> PosesOf(const face::Cast& cast, std::uint16_t face) {
  std::vector<face::Weights> poses;
  for (std::uint16_t e = 0; e < cast.expressions.size(); ++e) {
    face::Weights& pose = poses.emplace_back();
    pose.faces.Push(face, 1);
    const bool alone = cast.expressions[e].kind == face::ExpressionKind::kExpression;
    pose.expressions.Push(alone ? e : std::uint16_t{0}, 1);
    if (!alone) pose.channels.Push(e, 1);
  }
  face::Weights& asleep = poses.emplace_back();
  asleep.faces.Push(face, 1);
  asleep.lids_shut = {1, 1};
  return poses;
}

// The polygon's rim: corners, and what is kept of its edges. `start`: a kept edge, or 0.
struct Rim {
  std::vector<Index> vertices;
  std::size_t start = 0;
  bool has_edges = false;
};

Rim RimOf(const SplitPolygon& p, const std::vector<bool>& kept) {
  Rim rim;
  for (std::size_t i = 0; i < p.corners.size(); ++i) {
    rim.vertices.push_back(p.corners[i]);
    if (!kept[p.edges[i]]) continue;
    if (!rim.has_edges) rim.start = rim.vertices.size();
    rim.has_edges = true;
    rim.vertices.push_back(p.edges[i]);
  }
  return rim;
}

// The corner from which the diagonal lies closer to the middle; the same on both halves of a head.
std::size_t BestCorner(const SplitPolygon& p, const Shape& shape) {
  if (p.corners.size() != 4) return 0;
  const auto off = [&](std::size_t i) {
    return glm::distance(shape.fine[p.middle],
                         0.5F * (shape.fine[p.corners[i]] + shape.fine[p.corners[i + 2]]));
  };
  return off(0) <= off(1) ? 0 : 1;
}

// Round the middle, or a fan from one vertex of the rim: from a kept edge, since a fan from a corner would have a
// flat triangle along each kept edge that meets there.
void Append(const SplitPolygon& p, const std::vector<bool>& kept, const Shape& rest,
            std::vector<Triangle>& to) {
  const Rim rim = RimOf(p, kept);
  const std::size_t n = rim.vertices.size();
  const auto at = [&](std::size_t i) { return rim.vertices[i % n]; };
  if (kept[p.middle]) {
    for (std::size_t i = 0; i < n; ++i) to.push_back({at(i), at(i + 1), p.middle});
    return;
  }
  const std::size_t start = rim.has_edges ? rim.start : BestCorner(p, rest);
  for (std::size_t i = 1; i + 1 < n; ++i) to.push_back({at(start), at(start + i), at(start + i + 1)});
}

}  // namespace

// What is kept is found first, over all poses: a triangle is taken back only where it is flat in each of them.
std::vector<Triangle> SparseTriangles(const face::Cast& cast, std::uint16_t face, const Flatness& flatness) {
  const face::FineMesh& fine = cast.topology.fine;
  const std::vector<SplitPolygon> polygons = PolygonsOf(fine.triangles);
  if (polygons.empty()) return {};
  face::Composer composer(cast);
  Keeper keeper(fine, polygons, flatness);
  const std::vector<face::Weights> poses = PosesOf(cast, face);
  for (const face::Weights& pose : poses) keeper.LookAt(composer.Compose(pose, face::Detail::kFine));
  const std::vector<bool> kept = keeper.Kept();
  face::Weights at_rest;
  at_rest.faces.Push(face, 1);
  const Shape& rest = composer.Compose(at_rest, face::Detail::kFine);
  std::vector<Triangle> sparse;
  for (const SplitPolygon& p : polygons) Append(p, kept, rest, sparse);
  return sparse;
}

// What gleams shows how its surface turns more than skin does.
void LeaveOutFlat(face::Cast& cast) {
  constexpr float kGleamTurn_rad = 0.06F;
  const Flatness of_skin;
  for (std::uint16_t f = 0; f < cast.faces.size(); ++f) {
    Flatness flatness = of_skin;
    const bool gleams = cast.faces[f].surface.metal > 0 || cast.faces[f].surface.softness < 0.5F;
    if (gleams) flatness.turn_rad = kGleamTurn_rad;
    cast.faces[f].sparse = SparseTriangles(cast, f, flatness);
  }
}

}  // namespace kaori::mesh
