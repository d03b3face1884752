// Which vertices of a head become its control points.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/import/mesh_graph.h"

namespace kaori::import {

struct ChosenPoint {
  Index vertex = 0;  // Welded.
  std::string name;
  bool moves = false;  // Others hold the border still.
};

struct PointChoice {
  std::vector<ChosenPoint> points;
  std::vector<std::size_t> owner;  // By welded vertex: the point that is nearest along the surface.
};

struct PointOptions {
  std::size_t moving = 180;
  std::size_t still = 60;
};

// First the landmarks, then always the vertex that is farthest, along the surface, from all points so far,
// where distances count for more the more the surface moves (`mobility_m`, by vertex).
PointChoice ChoosePoints(const MeshGraph& graph, const HeadShape& head, const std::vector<float>& mobility_m,
                         const PointOptions& options);

}  // namespace kaori::import
