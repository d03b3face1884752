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

constexpr float kMoved_m = 1e-5F;
constexpr float kRigidShare = 0.02F;  // Teeth move as wholes: few points are enough for them.
constexpr float kPlaceMargin = 0.01F;
constexpr float kLipsReach_m = 0.015F;   // All of the motion this near to the mouth is the lips',
constexpr float kMouthReach_m = 0.045F;  // none beyond this.
constexpr float kIrisShare = 0.47F;      // Of the eyeball's radius.
constexpr glm::vec3 kIrisColour{0.085F, 0.045F, 0.022F};
constexpr glm::vec3 kNeckPivot_m{0, -0.07F, -0.015F};

std::vector<float> Mobility(const std::vector<WantedShape>& shapes, std::size_t vertices) {
  std::vector<float> mobility_m(vertices, 0.0F);
  for (const WantedShape& shape : shapes)
    for (std::size_t v = 0; v < shape.offsets.size(); ++v)
      mobility_m[v] = std::max(mobility_m[v], glm::length(shape.offsets[v]));
  return mobility_m;
}

// The texture's chart, larger or smaller as a whole so that it fills the parameter space with no stretch.
std::vector<glm::vec2> PlacesOf(const std::vector<glm::vec2>& uv) {
  glm::vec2 least = uv.front();
  glm::vec2 most = least;
  for (const glm::vec2& p : uv) {
    least = glm::min(least, p);
    most = glm::max(most, p);
  }
  const glm::vec2 room =
      (1 - 2 * kPlaceMargin) * glm::vec2(face::kParameterWidth_m, face::kParameterHeight_m);
  const glm::vec2 size = glm::max(most - least, glm::vec2(1e-6F));
  const float scale_m = std::min(room.x / size.x, room.y / size.y);
  std::vector<glm::vec2> places;
  for (const glm::vec2& p : uv) {
    const glm::vec2 from_middle = scale_m * (p - 0.5F * (least + most));
    places.push_back(glm::vec2(0.5F) +
                     from_middle / glm::vec2(face::kParameterWidth_m, face::kParameterHeight_m));
  }
  return places;
}

// Each edge of the artist's polygons once.
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

std::vector<float> MouthShareOf(const HeadShape& head) {
  std::vector<float> share(head.positions.size(), 0.0F);
  const std::vector<Landmark> marks = FindLandmarks(head);
  const auto left = std::ranges::find(marks, "left mouth corner", &Landmark::name);
  const auto right = std::ranges::find(marks, "right mouth corner", &Landmark::name);
  if (left == marks.end() || right == marks.end()) return share;
  const std::vector<float> jaw = Shares(head.jaw, share.size());
  const glm::vec3 along = left->at - right->at;
  for (std::size_t v = 0; v < share.size(); ++v) {
    const glm::vec3 from = head.positions[v] - right->at;
    const float t = glm::clamp(glm::dot(from, along) / glm::dot(along, along), 0.0F, 1.0F);
    const float near = 1 - glm::smoothstep(kLipsReach_m, kMouthReach_m, glm::distance(from, t * along));
    share[v] = std::max(near, glm::smoothstep(0.2F, 0.6F, jaw[v]));
  }
  return share;
}

face::Topology MakeTopology(const Heads& heads, const HeadShape& head, Index moving, const MeshGraph& graph) {
  face::Topology topology;
  topology.vertex_count = static_cast<Index>(heads.skin.size());
  topology.moving_count = moving;
  topology.uv = PlacesOf(heads.uv);
  topology.texture = heads.uv;
  topology.triangles = heads.triangles;
  topology.wires = WiresOf(heads.triangles, graph.welds());
  topology.twin = mesh::Twins(graph.welds());
  topology.mouth_share = MouthShareOf(head);
  topology.fine = MakeFineMesh(heads.triangles, graph.welds(), heads.uv);
  return topology;
}

face::SparseRows FirstRows(const face::SparseRows& rows, Index count) {
  face::SparseRows first;
  first.row_start.assign(rows.row_start.begin(),
                         rows.row_start.begin() + static_cast<std::ptrdiff_t>(count) + 1);
  first.column.assign(rows.column.begin(), rows.column.begin() + first.row_start.back());
  first.weight.assign(rows.weight.begin(), rows.weight.begin() + first.row_start.back());
  return first;
}

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

Index OrderByMotion(Heads& heads, std::vector<WantedShape>& shapes) {
  const std::vector<float> mobility_m = Mobility(shapes, heads.skin.size());
  std::vector<Index> order(heads.skin.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto moves = [&](Index v) { return mobility_m[v] > kMoved_m; };
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
  const MeshGraph graph(head.positions, heads.triangles);
  std::vector<float> mobility_m = Mobility(shapes, heads.skin.size());
  for (std::size_t v = 0; v < mobility_m.size(); ++v)
    if (heads.part[v] != PartOf::kSkin) mobility_m[v] *= kRigidShare;
  const PointChoice choice = ChoosePoints(graph, head, mobility_m, options);
  const face::SparseRows to_vertices = MakeSurfaceNet(graph, head.positions, heads.triangles, choice);
  face::Cast cast;
  cast.topology = MakeTopology(heads, head, moving, graph);
  cast.net = MakeNet(cast.topology, choice, to_vertices);
  for (const Head& one : heads.heads) cast.faces.push_back(MakeFace(one));
  cast.neck_pivot = kNeckPivot_m;
  const std::vector<Landmark> marks = FindLandmarks(head);
  const auto lip = std::ranges::find(marks, "upper lip", &Landmark::name);
  if (lip != marks.end()) cast.mouth_anchor = lip->at;
  return cast;
}

}  // namespace kaori::import
