// Which vertices of a head become its control points.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/import/mesh_graph.h"

namespace kaori::import {

// Names are those of landmarks where the point is one ("LC", "UC", "MC.l", "MC.r" for the mouth, as the stage
// knows it), else P and a number for points that move, R and a number for points at rest.
struct ChosenPoint {
  // Of the head, welded: points of both sides of a texture seam are one.
  Index vertex = 0;
  std::string name;
  // Others hold the border still: expressions have no displacement for them.
  bool moves = false;
};

// The points in the order in which they were chosen, and each one's region of the surface.
struct PointChoice {
  std::vector<ChosenPoint> points;
  // By welded vertex: the point that is nearest along the surface; MeshGraph::Nearest::kNobody where none
  // can be reached.
  std::vector<std::size_t> owner;
};

// How many at most. With 180 moving points a real head of 85 known expressions is met with a mean error of
// about 0.3 mm; 300 bring it to 0.2 mm.
struct PointOptions {
  // Landmarks that move count among these.
  std::size_t moving = 180;
  // Landmarks at rest do not count among these.
  std::size_t still = 60;
};

// First the landmarks, then always the vertex that is farthest, along the surface, from all points so far
// (farthest point sampling), where distances count for more the more the surface moves (`mobility_m`, by
// vertex, the longest offset of any shape). Points that move are chosen before those at rest. Fewer than
// `options` says where the surface has no more vertices. `graph` is of `head`.
PointChoice ChoosePoints(const MeshGraph& graph, const HeadShape& head, const std::vector<float>& mobility_m,
                         const PointOptions& options);

}  // namespace kaori::import
