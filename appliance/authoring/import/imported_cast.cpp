#include "appliance/authoring/import/imported_cast.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "appliance/authoring/import/fine_mesh.h"
#include "appliance/authoring/import/surface_net.h"

namespace kaori::import {
namespace {

// A hundredth of a millimetre: less is rounding of the file.
constexpr float kMoved_m = 1e-5F;
// Teeth move as wholes: few points are enough for them, and without this they would draw most of the
// points to themselves.
constexpr float kRigidShare = 0.02F;
// Of the unit square, on each side: control points at its border hold still.
constexpr float kUvMargin = 0.01F;
// All of the motion this near to the line between the mouth's corners is the lips',
constexpr float kLipsReach_m = 0.015F;
constexpr float kMouthReach_m = 0.045F;  // none beyond this.
// Of the eyeball's radius; in life 0.49.
constexpr float kIrisShare = 0.47F;
constexpr glm::vec3 kIrisColour{0.085F, 0.045F, 0.022F};
// The head turns about this point: 7 cm below the eyes, inside the neck, for a head of a grown person's size.
constexpr glm::vec3 kNeckPivot_m{0, -0.07F, -0.015F};

// The farthest that any wanted shape moves each vertex, metres.
std::vector<float> Mobility(const std::vector<WantedShape>& shapes, std::size_t vertices) {
  std::vector<float> mobility_m(vertices, 0.0F);
  for (const WantedShape& shape : shapes)
    for (std::size_t v = 0; v < shape.offsets.size(); ++v)
      mobility_m[v] = std::max(mobility_m[v], glm::length(shape.offsets[v]));
  return mobility_m;
}

// The texture's chart, larger or smaller as a whole so that it fills the parameter space with no stretch. The
// parameter space is a rectangle of kParameterWidth_m by kParameterHeight_m, brought to the unit square.
std::vector<glm::vec2> UvsWithin(const std::vector<glm::vec2>& uv) {
  glm::vec2 least = uv.front();
  glm::vec2 most = least;
  for (const glm::vec2& p : uv) {
    least = glm::min(least, p);
    most = glm::max(most, p);
  }
  const glm::vec2 room = (1 - 2 * kUvMargin) * glm::vec2(face::kParameterWidth_m, face::kParameterHeight_m);
  // A chart without width would be divided by zero; CheckUnfolding has refused it as flat.
  const glm::vec2 size = glm::max(most - least, glm::vec2(1e-6F));
  const float scale_m = std::min(room.x / size.x, room.y / size.y);
  std::vector<glm::vec2> within;
  for (const glm::vec2& p : uv) {
    const glm::vec2 from_middle = scale_m * (p - 0.5F * (least + most));
    within.push_back(glm::vec2(0.5F) +
                     from_middle / glm::vec2(face::kParameterWidth_m, face::kParameterHeight_m));
  }
  return within;
}

// Each edge of the artist's polygons once, and once across a seam: quads without their diagonals look as
// they were modelled.
std::vector<face::Line> WiresOf(const std::vector<Triangle>& triangles, const std::vector<Index>& weld) {
  std::set<std::pair<Index, Index>> edges;
  for (const mesh::Polygon& polygon : PolygonsOf(triangles)) {
    const std::size_t corners = polygon.size();
    for (std::size_t i = 0; i < corners; ++i)
      edges.insert(std::minmax(weld[polygon[i]], weld[polygon[(i + 1) % corners]]));
  }
  std::vector<face::Line> wires;
  for (const auto& [a, b] : edges)
    if (a != b) wires.push_back({a, b});
  return wires;
}

// How much of a vertex's motion gives way to the lip operator: all by the lips, and all that goes with the
// jaw. By the distance from the line between the corners, which is a good picture of a mouth from the front.
// All zero where there is no mouth.
std::vector<float> MouthShareOf(const HeadShape& head, const std::vector<Landmark>& marks) {
  std::vector<float> share(head.positions.size(), 0.0F);
  const auto left = LandmarkAt(marks, "left mouth corner");
  const auto right = LandmarkAt(marks, "right mouth corner");
  if (!left || !right) return share;
  const std::vector<float> jaw = Shares(head.jaw, share.size());
  const glm::vec3 along = *left - *right;
  for (std::size_t v = 0; v < share.size(); ++v) {
    const glm::vec3 from = head.positions[v] - *right;
    const float t = glm::clamp(glm::dot(from, along) / glm::dot(along, along), 0.0F, 1.0F);
    const float near = 1 - glm::smoothstep(kLipsReach_m, kMouthReach_m, glm::distance(from, t * along));
    // What moves with less than a fifth of the jaw is cheek or neck.
    share[v] = std::max(near, glm::smoothstep(0.2F, 0.6F, jaw[v]));
  }
  return share;
}

// The artist's texture coordinates serve twice: as they are for the texture, brought to the unit square for
// the parameter space.
face::Topology MakeTopology(const Heads& heads, std::vector<float> mouth_share, Index moving,
                            const MeshGraph& graph) {
  face::Topology topology;
  topology.vertex_count = static_cast<Index>(heads.skin.size());
  topology.moving_count = moving;
  topology.uv = UvsWithin(heads.uv);
  topology.texture = heads.uv;
  topology.triangles = heads.triangles;
  topology.wires = WiresOf(heads.triangles, graph.welds());
  topology.twin = mesh::Twins(graph.welds());
  topology.mouth_share = std::move(mouth_share);
  topology.fine = MakeFineMesh(heads.triangles, graph.welds(), heads.uv);
  return topology;
}

// The rows of the moving vertices: the others would only hold zeros.
face::SparseRows FirstRows(const face::SparseRows& rows, Index count) {
  face::SparseRows first;
  first.row_start.assign(rows.row_start.begin(),
                         rows.row_start.begin() + static_cast<std::ptrdiff_t>(count) + 1);
  first.column.assign(rows.column.begin(), rows.column.begin() + first.row_start.back());
  first.weight.assign(rows.weight.begin(), rows.weight.begin() + first.row_start.back());
  return first;
}

// Each control point lies on a vertex, so its place on a face is one weight of 1. Points that hold still are
// no part of a net.
face::ControlNet MakeNet(const face::Topology& topology, const PointChoice& choice,
                         const face::SparseRows& to_vertices) {
  face::ControlNet net;
  net.surface.row_start.push_back(0);
  for (const ChosenPoint& point : choice.points) {
    if (!point.moves) continue;
    net.points.push_back({point.name, topology.uv[point.vertex]});
    net.surface.column.push_back(point.vertex);
    net.surface.weight.push_back(1);
    net.surface.row_start.push_back(static_cast<std::uint32_t>(net.surface.column.size()));
  }
  net.to_cage = FirstRows(to_vertices, topology.moving_count);
  return net;
}

// Lashes are 0: the artist's own are part of the mesh.
face::Face MakeFace(const Head& head) {
  face::Face face;
  face.name = head.name;
  face.positions = head.positions;
  face.eyes = head.eyes;
  face.eye_look = {kIrisColour, kIrisShare * head.eyes[0].radius_m, 0, 0};
  face.surface.flat = {0.72F, 0.50F, 0.40F};
  return face;
}

}  // namespace

// A stable partition by the longest offset of any shape.
Index OrderByMotion(Heads& heads, std::vector<WantedShape>& shapes) {
  const std::vector<float> mobility_m = Mobility(shapes, heads.skin.size());
  std::vector<Index> order(heads.skin.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto moves = [&](Index v) { return mobility_m[v] > kMoved_m; };
  // Stable, so that neighbours in the file stay neighbours in memory.
  const auto rest = std::stable_partition(order.begin(), order.end(), moves);
  const auto moving = static_cast<Index>(rest - order.begin());
  Reorder(order, heads);
  for (WantedShape& shape : shapes) {
    if (shape.offsets.empty()) continue;
    Offsets ordered;
    for (const Index v : order) ordered.push_back(shape.offsets[v]);
    shape.offsets = std::move(ordered);
  }
  return moving;
}

face::Cast MakeCast(const Heads& heads, const std::vector<WantedShape>& shapes, Index moving,
                    const PointOptions& options) {
  const HeadShape head = ShapeOfHeads(heads);
  // Of all triangles, teeth too: their vertices need points of their own.
  const MeshGraph graph(head.positions, heads.triangles);
  std::vector<float> mobility_m = Mobility(shapes, heads.skin.size());
  for (std::size_t v = 0; v < mobility_m.size(); ++v)
    if (heads.part[v] != PartOf::kSkin) mobility_m[v] *= kRigidShare;
  const PointChoice choice = ChoosePoints(graph, head, mobility_m, options);
  const face::SparseRows to_vertices = MakeSurfaceNet(graph, head.positions, heads.triangles, choice);
  face::Cast cast;
  const std::vector<Landmark> marks = FindLandmarks(head);
  cast.topology = MakeTopology(heads, MouthShareOf(head, marks), moving, graph);
  cast.net = MakeNet(cast.topology, choice, to_vertices);
  for (const Head& one : heads.heads) cast.faces.push_back(MakeFace(one));
  cast.neck_pivot = kNeckPivot_m;
  // The anchor is where lent teeth are scaled about; without a mouth it is the origin.
  cast.mouth_anchor = LandmarkAt(marks, "upper lip").value_or(cast.mouth_anchor);
  return cast;
}

}  // namespace kaori::import
