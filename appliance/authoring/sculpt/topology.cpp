#include "appliance/authoring/sculpt/topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/fine_mesh.h"
#include "appliance/authoring/sculpt/texture_map.h"

namespace kaori::sculpt {
namespace {

// How far each ring of the eye, 0 .. 7, follows the lid's edge when it shuts; below the eye the skin follows
// less (kLowerSkin, rings 1 to 3). The rim, ring 0, stays where it is and is only kept out of the ball.
constexpr int kRingsOfLid = kEyeRings + 1;
constexpr std::array<float, kRingsOfLid> kFollow{0, 0.08F, 0.28F, 0.56F, 0.86F, 1, 1, 1};
constexpr float kLowerSkin = 0.6F;

// By the shorter diagonal on the reference face, which is the same on both sides; equal ones by the first.
void SplitQuads(const Cage& cage, const HalfShape& reference, std::vector<face::Triangle>& triangles) {
  const auto length = [&](Index a, Index b) {
    return glm::distance(reference.position[cage.vertices[a].half],
                         reference.position[cage.vertices[b].half]);
  };
  for (const Quad& quad : cage.quads) {
    const std::vector<Index> q = Corners(quad);
    if (q.size() == 3) {
      triangles.push_back({q[0], q[1], q[2]});
    } else if (length(q[0], q[2]) <= length(q[1], q[3])) {
      triangles.push_back({q[0], q[1], q[2]});
      triangles.push_back({q[0], q[2], q[3]});
    } else {
      triangles.push_back({q[0], q[1], q[3]});
      triangles.push_back({q[1], q[2], q[3]});
    }
  }
}

// Each edge once, also on seams: what the wireframe style shows are the quads, without diagonals.
std::vector<face::Line> Wires(const Cage& cage) {
  std::set<std::pair<Index, Index>> edges;
  for (const Quad& quad : cage.quads) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Index a = cage.Weld(quad[i]);
      const Index b = cage.Weld(quad[(i + 1) % 4]);
      if (a != b) edges.emplace(std::min(a, b), std::max(a, b));
    }
  }
  std::vector<face::Line> wires;
  for (const auto& [a, b] : edges) wires.push_back({a, b});
  return wires;
}

// 0 at `from` and before, 1 at `to` and beyond; `from` may be the larger of the two, as where something fades
// out.
float SmoothStep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return static_cast<float>(t * t * (3 - 2 * t));
}

// Lips, jaw and chin move with the mouth; cheeks and nose with the expression. On the grid it fades in from v
// = -3.6 cm (the nose) down to -5.0, and out from |u| = 4.5 to 7.5.
float MouthShare(const Key& key, glm::dvec2 uv_cm) {
  if (key.region == Region::kMouth) return 1;
  return SmoothStep(-3.6, -5.0, uv_cm.y) * SmoothStep(7.5, 4.5, std::abs(uv_cm.x));
}

// Rows are rings 0 .. 7, columns run from the inner to the outer corner; upper and lower share both corners.
// -j wraps to 28 - j, the lower partner.
face::LidRig MakeLidRig(const Cage& cage, const std::vector<Index>& side) {
  face::LidRig rig;
  rig.columns = kEyeRim / 2 + 1;
  rig.rings = kRingsOfLid;
  rig.margin_ring = kLidRing;
  for (int k = 0; k < kRingsOfLid; ++k) {
    for (int j = 0; j < rig.columns; ++j) {
      rig.upper.push_back(side[cage.half.At(Region::kEye, j, k)]);
      rig.lower.push_back(side[cage.half.At(Region::kEye, -j, k)]);
    }
    const float follow = kFollow[static_cast<std::size_t>(k)];
    rig.follow_upper.push_back(follow);
    rig.follow_lower.push_back(k <= 3 ? follow * kLowerSkin : follow);
  }
  return rig;
}

}  // namespace

// Everything here follows from the cage and the reference's uv; no face's shape has a part in it but
// in the diagonals.
face::Topology MakeTopology(const Cage& cage, const HalfShape& reference) {
  const std::vector<glm::dvec2> uvs_cm = WholeUvs(cage, reference.uv_cm);
  face::Topology topology;
  topology.vertex_count = static_cast<Index>(cage.vertices.size());
  topology.moving_count = cage.moving_count;
  for (Index v = 0; v < topology.vertex_count; ++v) {
    topology.uv.emplace_back(UnitFromUv(uvs_cm[v]));
    topology.texture.emplace_back(TextureFromUv(uvs_cm[v]));
    topology.twin.push_back(cage.vertices[v].twin);
    topology.mouth_share.push_back(MouthShare(cage.key(v), uvs_cm[v]));
  }
  SplitQuads(cage, reference, topology.triangles);
  topology.wires = Wires(cage);
  topology.lids = {MakeLidRig(cage, cage.left), MakeLidRig(cage, cage.right)};
  topology.fine = MakeFineMesh(cage, uvs_cm);
  return topology;
}

}  // namespace kaori::sculpt
